#include <array>
#include <cstdlib>

#include "drivers/wire/can/candump.hpp"

using namespace drydock::wire;

/// Every line that can be parsed prints to a line with the same frame.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto line = candump::parse_line({reinterpret_cast<const char*>(data), size});
  if (!line) return 0;
  std::array<std::uint8_t, candump::longest_line> out;
  const std::size_t printed = candump::encode(*line, out);
  if (printed == 0) std::abort();
  const auto again = candump::parse_line({reinterpret_cast<const char*>(out.data()), printed - 1});
  if (!again || !(again->frame == line->frame)) std::abort();
  return 0;
}
