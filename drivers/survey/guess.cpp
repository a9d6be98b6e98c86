#include "drivers/survey/guess.hpp"

#include <algorithm>

namespace drydock::survey {
namespace {

/// A few damaged bytes make no binary protocol of it.
bool is_text(wire::Bytes capture) {
  const auto plain = std::ranges::count_if(capture, [](std::uint8_t c) {
    return (c >= 0x20 && c <= 0x7E) || c == '\t' || c == '\r' || c == '\n';
  });
  return static_cast<std::size_t>(plain) * 100 >= capture.size() * 99;
}

}  // namespace

std::string guess_description(wire::Bytes capture) {
  constexpr std::string_view head =
      "# A guess from a capture: nothing here is certain. Compare it with the maker's manual, "
      "give\n"
      "# each column that is measured `field` and `unit` instead of `name`, and run drydock "
      "check.\n"
      "# docs/sensors/described.md\n\n"
      "[sensor]\ntitle = \"unknown\"\nkind = \"depth\"                # or dvl, emlog, gnss, imu, "
      "actuator, attitude\n";
  std::string found = guess_text(capture);
  if (found.empty() && !is_text(capture)) found = guess_binary(capture);
  return found.empty() ? found : std::string(head) + found;
}

}  // namespace drydock::survey
