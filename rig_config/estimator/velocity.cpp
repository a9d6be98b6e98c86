#include "rig_config/estimator/velocity.hpp"

#include "rig_config/checks/checks.hpp"
#include "rig_config/toml/checked_file.hpp"
#include "rig_config/toml/read_keys.hpp"
#include "rig_config/typed/build.hpp"

namespace drydock::rig_config {

void read_kind(const Node& table, VelocityConfig& into) {
  into.inertial = read_inertial(table);
  if (const Node* filter = table.find("filter"); filter && filter->text == "paper")
    into.method = VelocityMethod::paper;
  read(table, "log", into.log);
  read(table, "actuators", into.actuators);
}

Problems read_kind_files(const EstimatorBlock& block, VelocityConfig& into) {
  Problems problems = read_grades(block, {{"imu", DeviceKind::imu, into.inertial.imu_grade},
                                          {"dvl", DeviceKind::dvl, into.inertial.dvl_grade},
                                          {"log", DeviceKind::emlog, into.log_grade},
                                          {"depth", DeviceKind::depth, into.inertial.depth_grade}});
  if (const Node* reference = block.table.find("vehicle")) {
    const auto vehicle = read_checked_file(beside(block.file, reference->text), FileKind::vehicle);
    if (!vehicle) {
      append(problems, vehicle.error());
    } else if (auto missing = fins_are_missing(*vehicle, beside(block.file, reference->text));
               !missing.empty()) {
      append(problems, std::move(missing));
    } else {
      into.vehicle = build_vehicle(*vehicle);
    }
  }
  return problems;
}

std::vector<std::string> compared_devices(const VelocityConfig& config) {
  return {config.log, config.inertial.dvl, config.inertial.depth};
}

}  // namespace drydock::rig_config
