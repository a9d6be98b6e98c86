#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

namespace drydock::score {

/// The covariance of a ROS message, where a variance that is not known is NaN. Empty: `flaw` says
/// why the matrix tells nothing, behind "the covariance".
struct KnownCovariance {
  std::optional<Eigen::Matrix3d> matrix;
  std::string flaw;
};

/// Whether the number with this variance is none, as ROS says it.
bool is_of_nothing(double variance);

KnownCovariance known_covariance(Eigen::Matrix3d covariance);

}  // namespace drydock::score
