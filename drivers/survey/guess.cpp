#include "drivers/survey/guess.hpp"

namespace drydock::survey {

std::string guess_description(wire::Bytes capture) {
  constexpr std::string_view head =
      "# A guess from a capture: nothing here is certain. Compare it with the maker's manual, "
      "give\n"
      "# each column that is measured `field` and `unit` instead of `name`, and run drydock "
      "check.\n"
      "# docs/sensors/described.md\n\n"
      "[sensor]\ntitle = \"unknown\"\nkind = \"depth\"                # or dvl, emlog, gnss, imu, "
      "actuator\n";
  std::string found = guess_text(capture);
  if (found.empty()) found = guess_binary(capture);
  return found.empty() ? found : std::string(head) + found;
}

}  // namespace drydock::survey
