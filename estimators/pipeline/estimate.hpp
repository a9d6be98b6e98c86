#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>

#include "drivers/measurement/stamp.hpp"
#include "estimators/pipeline/integrity.hpp"

namespace drydock::pipeline {

using measurement::Stamp;

/// Attitude estimate with its covariance.
struct AttitudeEstimate {
  Stamp valid_at{};
  std::uint16_t estimator = 0;  ///< index in the rig
  double roll_rad = 0, pitch_rad = 0;
  std::optional<double> yaw_rad;                         ///< empty if not estimated
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  ///< rad2, roll and pitch
  std::uint32_t fed_by = 0;                              ///< bit i: device i of the rig contributed
  Integrity integrity;
};

}  // namespace drydock::pipeline
