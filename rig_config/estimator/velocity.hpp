#pragma once

#include <cstdint>
#include <optional>

#include "rig_config/estimator/facts.hpp"
#include "rig_config/estimator/inertial.hpp"
#include "rig_config/vehicle.hpp"

namespace drydock::rig_config {

enum class VelocityMethod : std::uint8_t { coupled, paper };

/// An inertial navigation with a model of the vehicle. docs/estimators/velocity.md
struct VelocityConfig {
  static constexpr std::array devices{DeviceKey{"log", measurement::Kind::emlog},
                                      DeviceKey{"dvl", measurement::Kind::dvl},
                                      DeviceKey{"depth", measurement::Kind::depth},
                                      DeviceKey{"actuators", measurement::Kind::actuator}};
  static constexpr EstimatorFacts facts{.name = "velocity",
                                        .devices = devices,
                                        .gives_positions = true,
                                        .has_gate = true,
                                        .has_innovations = true};

  InertialConfig inertial;
  VelocityMethod method = VelocityMethod::coupled;
  std::string log, actuators;  ///< device names
  EmulateConfig log_grade;     ///< from the sensor file
  std::optional<VehicleConfig> vehicle;
};

void read_kind(const Node& table, VelocityConfig& into);
std::vector<Problem> read_kind_files(const EstimatorBlock& block, VelocityConfig& into);

/// Speed log, DVL and depth sensor, as far as the estimator has them.
std::vector<std::string> compared_devices(const VelocityConfig& config);

}  // namespace drydock::rig_config
