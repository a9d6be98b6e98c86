#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "rig_config/estimator/attitude_start.hpp"
#include "rig_config/estimator/facts.hpp"

namespace drydock::rig_config {

enum class LevelingFilter : std::uint8_t { robust, augmented, paper };

/// Roll and pitch from an IMU and a speed log. docs/estimators/leveling.md
struct LevelingConfig {
  static constexpr std::array devices{DeviceKey{"log", measurement::Kind::emlog}};
  static constexpr EstimatorFacts facts{
      .name = "leveling", .devices = devices, .has_gate = true, .has_innovations = true};

  LevelingFilter filter = LevelingFilter::robust;
  bool stationary = false;  ///< measurement model: all three velocities zero
  std::string log;          ///< device name; empty if stationary
  AttitudeStart start;
};

void read_kind(const Node& table, LevelingConfig& into);

/// The names of the devices whose values the estimator compares with what it expects.
std::vector<std::string> compared_devices(const LevelingConfig& config);

}  // namespace drydock::rig_config
