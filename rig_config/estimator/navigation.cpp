#include "rig_config/estimator/navigation.hpp"

#include "rig_config/load.hpp"
#include "rig_config/toml/read_keys.hpp"

namespace drydock::rig_config {

void read_kind(const Node& table, NavigationConfig& into) {
  into.inertial = read_inertial(table);
  read(table, "gnss", into.gnss);
  read(table, "heading", into.heading);
}

Problems read_kind_files(const EstimatorBlock& block, NavigationConfig& into) {
  return read_grades(block, {{"imu", DeviceKind::imu, into.inertial.imu_grade},
                             {"dvl", DeviceKind::dvl, into.inertial.dvl_grade},
                             {"depth", DeviceKind::depth, into.inertial.depth_grade},
                             {"heading", DeviceKind::attitude, into.heading_grade}});
}

std::vector<std::string> compared_devices(const NavigationConfig& config) {
  return {config.inertial.dvl, config.inertial.depth, config.gnss, config.heading};
}

}  // namespace drydock::rig_config
