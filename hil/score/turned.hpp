#pragma once

#include <cmath>
#include <optional>

#include "hil/score/track.hpp"

namespace drydock::score {

/// NaN becomes 0: what is not told adds nothing to a sum.
inline Eigen::Vector3d or_zero(const Eigen::Vector3d& v) { return v.array().isNaN().select(0, v); }

/// NaN for each axis that after a turn takes from one that is not told; else 0.
inline Eigen::Vector3d untold_after(const Eigen::Matrix3d& by, const Eigen::Vector3d& before) {
  Eigen::Vector3d marks = Eigen::Vector3d::Zero();
  for (Eigen::Index to = 0; to < 3; ++to)
    for (Eigen::Index from = 0; from < 3; ++from)
      if (by(to, from) != 0 && std::isnan(before[from])) marks[to] = before[from];
  return marks;
}

inline Eigen::Vector3d turned_vector(const Eigen::Matrix3d& by, const Eigen::Vector3d& v) {
  return by * or_zero(v) + untold_after(by, v);
}

inline std::optional<Eigen::Matrix3d> turned(const Eigen::Matrix3d& by,
                                             std::optional<Eigen::Matrix3d> covariance) {
  if (!covariance) return {};
  const Eigen::Vector3d marks = untold_after(by, covariance->diagonal());
  covariance->diagonal() = or_zero(covariance->diagonal());
  covariance = by * *covariance * by.transpose();
  covariance->diagonal() += marks;
  return covariance;
}

}  // namespace drydock::score
