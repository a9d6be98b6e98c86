#include "rig_config/estimator/roll.hpp"

#include "drivers/measurement/units.hpp"
#include "rig_config/toml/read_keys.hpp"

namespace drydock::rig_config {

void read_kind(const Node& table, RollConfig& into) {
  constexpr double degree_per_root_hour = units::degree / 60;
  read(table, "gnss", into.gnss);
  const Node* roll = table.find("roll");
  if (!roll) return;
  read_axis(*roll, "antenna_axis", into.antenna_axis);
  read(*roll, "boresight_cno_dbhz", into.boresight_cno_dbhz);
  read(*roll, "lowest_cno_dbhz", into.lowest_cno_dbhz);
  read(*roll, "cno_resolution_db", into.cno_resolution_db);
  read(*roll, "power_noise", into.power_noise);
  read(*roll, "angular_random_walk_degprth", into.angular_random_walk, degree_per_root_hour);
  read(*roll, "gyro_bias_degps", into.gyro_bias_radps, units::degree);
  read(*roll, "angle_of_attack_deg", into.angle_of_attack_rad, units::degree);
}

std::vector<std::string> compared_devices(const RollConfig&) { return {}; }

}  // namespace drydock::rig_config
