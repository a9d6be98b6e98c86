#pragma once

#include <Eigen/Core>
#include <optional>

#include "drivers/wire/dvl/ad2cp_messages.hpp"

namespace drydock::device {

/// The velocity of a Nortek DVL in its own axes, from X, Y, Z1 and Z2 with their figures of merit.
struct Ad2cpSolution {
  std::optional<Eigen::Vector3d> velocity;  ///< m/s; empty unless X, Y and a Z are there
  /// (m/s)2, from the figures of merit as 1 sigma; empty if one that it needs is missing.
  std::optional<Eigen::Matrix3d> covariance;
  std::optional<double> error_velocity_mps;               ///< Z1 less Z2
  std::optional<double> after_trigger_s, after_output_s;  ///< mean over the axes that are there
};

/// Two Z count by the inverse squares of their merits, or alike if a merit is missing.
Ad2cpSolution solve(const wire::ad2cp::Estimates& axes);

}  // namespace drydock::device
