#include "rig_config/estimator/attitude_start.hpp"

#include "drivers/measurement/units.hpp"
#include "rig_config/toml/read_keys.hpp"

namespace drydock::rig_config {

AttitudeStart read_attitude_start(const Node& table) {
  AttitudeStart start;
  std::string from;
  read(table, "start", from);
  start.accelerometer = from != "given";
  read(table, "initial_roll_deg", start.initial_roll_rad, units::degree);
  read(table, "initial_pitch_deg", start.initial_pitch_rad, units::degree);
  read(table, "latitude_deg", start.latitude_rad, units::degree);
  read(table, "heading_deg", start.heading_rad, units::degree);
  return start;
}

}  // namespace drydock::rig_config
