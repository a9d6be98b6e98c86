#include "hil/characterize/quantity.hpp"

#include "drivers/measurement/units.hpp"

namespace drydock::characterize {

std::vector<Quantity> quantities_of(rig_config::DeviceKind kind) {
  using enum measurement::Kind;
  using rig_config::EmulateConfig;
  constexpr auto primary = &EmulateConfig::primary, secondary = &EmulateConfig::secondary;
  using units::degree, units::micro_g;
  constexpr std::array<std::string_view, 3> xyz{"x", "y", "z"}, ned{"north", "east", "down"};
  switch (kind) {
    case imu:
      return {{"gyro", primary, 0, xyz, "deg/h", units::degree_per_hour, 0.1 * degree, true, true},
              {"accelerometer", secondary, 1, xyz, "ug", micro_g, 5e3 * micro_g, true, true}};
    case dvl: return {{"velocity", primary, 0, xyz, "m/s", 1, 0.05}};
    case emlog: return {{"speed", primary, 0, {"ahead", "across", ""}, "m/s", 1, 0.05}};
    case depth: return {{"pressure", primary, 0, {"", "", ""}, "Pa", 1, 500, false, true}};
    case gnss:
      return {{"position", primary, 0, ned, "m", 1, 10},
              {"velocity", secondary, 1, ned, "m/s", 1, 0.2}};
    case actuator:
      return {{"angle", primary, 0, {"rudder", "stern", "bow"}, "deg", degree, 0.5 * degree},
              {"shaft", secondary, 1, {"", "", ""}, "rpm", units::revolution_per_minute, 1}};
    case attitude:
      return {{"attitude", primary, 0, {"roll", "pitch", "heading"}, "deg", degree, 0.5 * degree},
              {"turn", secondary, 1, {"", "", ""}, "deg/s", degree, 0.1 * degree}};
  }
  return {};
}

}  // namespace drydock::characterize
