#pragma once

#include <optional>

#include "drivers/measurement/measurement.hpp"

namespace drydock::device {

/// A merit of 0 would say that the velocity is exact, so it is none.
inline std::optional<double> merit_of(const std::optional<double>& told_mps) {
  return told_mps && *told_mps > 0 ? told_mps : std::nullopt;
}

/// Adds the rig's sigma, m/s in each axis, to a velocity whose DVL says nothing about its accuracy.
inline void add_sigma_of_rig(measurement::BottomVelocity& sample,
                             const std::optional<double>& sigma_mps) {
  if (!sigma_mps || !sample.velocity) return;
  if (sample.velocity_covariance || sample.figure_of_merit_mps) return;
  sample.velocity_covariance = *sigma_mps * *sigma_mps * Eigen::Matrix3d::Identity();
}

}  // namespace drydock::device
