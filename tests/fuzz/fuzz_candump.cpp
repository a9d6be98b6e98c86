#include <array>
#include <cstdlib>

#include "drivers/wire/candump.hpp"

using namespace drydock::wire;

/// Whatever is read prints to a line that reads as the same frame.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Framer<Candump::max_frame> framer;
  framer.feed({data, size}, Candump::scan, [](Bytes frame, std::size_t) {
    const auto message = Candump::decode(frame);
    if (!message) std::abort();
    const auto& line = std::get<candump::Line>(*message);
    std::array<std::uint8_t, Candump::max_frame> out;
    const auto again = Candump::decode(Bytes{out.data(), candump::encode(line, out)});
    if (!again || !(std::get<candump::Line>(*again).frame == line.frame)) std::abort();
  });
  return 0;
}
