#pragma once

#include "estimators/leveling/leveling_options.hpp"

namespace drydock::leveling {

/// How well an IMU measures, as its sensor file says: one standard deviation of the worst axis; 0:
/// not known, or none.
struct ImuGrade {
  double angle_noise_rad = 0;     ///< per sqrt(s)
  double velocity_noise_mps = 0;  ///< per sqrt(s)
  double gyro_bias_radps = 0, accelerometer_bias_mps2 = 0;
  double gyro_bias_walk_radps = 0, accelerometer_bias_walk_mps2 = 0;  ///< per sqrt(s)
  double rate_share = 0;  ///< of a rate, by scale factor and misalignment
};

/// The options of a filter for an IMU of this grade: (A12) of docs/estimators/leveling.md. An IMU
/// that is better than that of the paper's Table 1 changes nothing.
LevelingOptions worsened(LevelingOptions options, FilterKind kind, const ImuGrade& imu);

}  // namespace drydock::leveling
