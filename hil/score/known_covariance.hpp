#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>

namespace drydock::score {

/// The covariance of a ROS message, where a variance that is not known is NaN. Empty: `flaw` says
/// why the matrix tells nothing, behind "the covariance".
struct KnownCovariance {
  std::optional<Eigen::Matrix3d> matrix;
  std::string flaw;
};

/// ROS says so of a variance by 0 or below, or by one that is as large.
inline constexpr double large_variance = 1e6;

/// Whether the number with this variance is none, as ROS says it.
bool is_of_nothing(double variance);

/// Which of roll, pitch, heading are none by the variances of turns about east, north, up. All are
/// told where all variances are large: an attitude may be told, and nobody says how good it is.
/// `is_default`: the attitude is that of a message that nobody filled.
std::array<bool, 3> angles_of_nothing(const Eigen::Matrix3d& turns, bool is_default);

KnownCovariance known_covariance(Eigen::Matrix3d covariance);

}  // namespace drydock::score
