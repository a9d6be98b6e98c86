#pragma once

#include "rig_config/estimator/facts.hpp"
#include "rig_config/estimator/inertial.hpp"

namespace drydock::rig_config {

/// Position, velocity and attitude from an IMU and aiding sensors. docs/estimators/navigation.md
struct NavigationConfig {
  static constexpr std::array devices{DeviceKey{"gnss", measurement::Kind::gnss},
                                      DeviceKey{"dvl", measurement::Kind::dvl},
                                      DeviceKey{"depth", measurement::Kind::depth},
                                      DeviceKey{"heading", measurement::Kind::attitude}};
  static constexpr EstimatorFacts facts{.name = "navigation",
                                        .devices = devices,
                                        .gives_positions = true,
                                        .has_gate = true,
                                        .has_innovations = true};

  InertialConfig inertial;
  std::string gnss, heading;    ///< device names
  EmulateConfig heading_grade;  ///< from the sensor file
};

void read_kind(const Node& table, NavigationConfig& into);
std::vector<Problem> read_kind_files(const EstimatorBlock& block, NavigationConfig& into);

/// DVL, depth sensor, receiver and compass, as far as the estimator has them.
std::vector<std::string> compared_devices(const NavigationConfig& config);

}  // namespace drydock::rig_config
