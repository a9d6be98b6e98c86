#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "rig_config/estimator/attitude_start.hpp"
#include "rig_config/estimator/facts.hpp"

namespace drydock::rig_config {

enum class MixingType : std::uint8_t { compensated, type1, type2, type3 };

/// Roll and pitch from an IMU and a speed log. docs/estimators/mixing.md
struct MixingConfig {
  static constexpr std::array devices{DeviceKey{"log", measurement::Kind::emlog}};
  static constexpr EstimatorFacts facts{.name = "mixing", .devices = devices};

  MixingType type = MixingType::compensated;
  std::string log;  ///< device name
  AttitudeStart start;
  double pivot_m = 0;  ///< point without side slip, ahead of the origin; 0: unknown
};

void read_kind(const Node& table, MixingConfig& into);

/// None: the filter has no innovation.
std::vector<std::string> compared_devices(const MixingConfig& config);

}  // namespace drydock::rig_config
