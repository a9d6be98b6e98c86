#include "rig_config/estimator/reckoning.hpp"

#include "drivers/measurement/units.hpp"
#include "rig_config/toml/read_keys.hpp"

namespace drydock::rig_config {

void read_kind(const Node& table, ReckoningConfig& into) {
  read(table, "dvl", into.dvl);
  read(table, "log", into.log);
  read(table, "heading", into.heading);
  read(table, "depth", into.depth);
  read(table, "gnss", into.gnss);
  read(table, "sea_level_m", into.sea_level_m);
  const Node* reckoning = table.find("reckoning");
  if (!reckoning) return;
  into.latitude_rad = read_if(*reckoning, "latitude_deg", units::degree);
  into.longitude_rad = read_if(*reckoning, "longitude_deg", units::degree);
  read(*reckoning, "depth_m", into.depth_m);
  read(*reckoning, "variation_deg", into.variation_rad, units::degree);
  read(*reckoning, "position_sigma_m", into.position_sigma_m);
  read(*reckoning, "depth_sigma_m", into.depth_sigma_m);
  read(*reckoning, "heading_sigma_deg", into.heading_sigma_rad, units::degree);
  read(*reckoning, "tilt_sigma_deg", into.tilt_sigma_rad, units::degree);
  read(*reckoning, "scale_sigma", into.scale_sigma);
  read(*reckoning, "current_sigma_mps", into.current_sigma_mps);
  read(*reckoning, "velocity_sigma_mps", into.velocity_sigma_mps);
  read(*reckoning, "water_speed_sigma_mps", into.water_speed_sigma_mps);
  read(*reckoning, "wander_mps_per_root_s", into.wander_mps_per_root_s);
  read(*reckoning, "gap_s", into.gap_s);
}

std::vector<std::string> compared_devices(const ReckoningConfig& config) { return {config.gnss}; }

}  // namespace drydock::rig_config
