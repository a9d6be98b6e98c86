#pragma once

#include <Eigen/Eigenvalues>
#include <cmath>

namespace drydock::measurement {

/// Of a matrix that is scaled to correlations: programs that compute in 32 bits round as much.
inline constexpr double covariance_rounding = 1e-6;

/// Why a matrix can be no covariance: "is not symmetric"; null if it can. Variances of 0 and
/// correlations of 1 are allowed.
inline const char* covariance_flaw(const Eigen::Matrix3d& matrix) {
  if (!matrix.allFinite()) return "has a number that is not finite";
  if ((matrix.diagonal().array() < 0).any()) return "has a negative variance";
  const Eigen::Vector3d sigmas = matrix.diagonal().cwiseSqrt();
  Eigen::Matrix3d correlation = Eigen::Matrix3d::Identity();
  for (Eigen::Index i = 0; i < 3; ++i)
    for (Eigen::Index k = 0; k < i; ++k) {
      const double scale = sigmas[i] * sigmas[k], allowed = covariance_rounding * scale;
      if (!(std::abs(matrix(i, k) - matrix(k, i)) <= allowed)) return "is not symmetric";
      if (!(std::abs(matrix(i, k)) <= scale + allowed)) return "has a correlation beyond 1";
      if (scale > 0) correlation(i, k) = matrix(i, k) / scale;
    }
  // The solver reads the lower triangle.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> of(correlation, Eigen::EigenvaluesOnly);
  const bool positive = of.eigenvalues().minCoeff() >= -covariance_rounding;
  return positive ? nullptr : "has a direction with a negative variance";
}

}  // namespace drydock::measurement
