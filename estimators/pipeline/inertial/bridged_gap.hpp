#pragma once

#include <cmath>

namespace drydock::pipeline {

/// Missing samples are interpolated on a line between their neighbours. The error of the integral
/// is the second derivative times T^3 / 12. One sigma of the second derivative: rate .5 rad/s3,
/// specific force 5 m/s4; chosen.
struct BridgedGap {
  explicit BridgedGap(double seconds)
      : velocity_sigma_mps(5 * std::pow(seconds, 3) / 12),
        angle_sigma_rad(0.5 * std::pow(seconds, 3) / 12) {}

  /// Of a turn that is not known by so much.
  static BridgedGap of_turn(double angle_sigma_rad) {
    BridgedGap gap(0);
    gap.angle_sigma_rad = angle_sigma_rad;
    return gap;
  }

  double velocity_sigma_mps, angle_sigma_rad;
};

}  // namespace drydock::pipeline
