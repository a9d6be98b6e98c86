#include <cstdlib>

#include "drivers/wire/can/slcan.hpp"

using namespace drydock::wire;

/// decode understands every frame that scan finds.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Framer<Slcan::max_frame> framer;
  framer.feed({data, size}, Slcan::scan, [](Bytes frame, std::size_t) {
    if (!Slcan::decode(frame)) std::abort();
  });
  return 0;
}
