#pragma once

#include <cmath>

namespace drydock::pipeline {

/// Missing samples are taken from the line between their neighbours, which is wrong by the second
/// derivative times T^3 / 12: of rate .5 rad/s3, of specific force 5 m/s4, one sigma; chosen.
struct BridgedGap {
  explicit BridgedGap(double seconds)
      : velocity_sigma_mps(5 * std::pow(seconds, 3) / 12),
        angle_sigma_rad(0.5 * std::pow(seconds, 3) / 12) {}

  double velocity_sigma_mps, angle_sigma_rad;
};

}  // namespace drydock::pipeline
