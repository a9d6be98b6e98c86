#pragma once

#include <Eigen/Core>
#include <functional>

namespace drydock::calibration {

/// Normal residuals with the sigma that is expected of each; both may depend on the parameters.
struct Normals {
  Eigen::VectorXd residual, sigma;
};

/// At values of the parameters. The number of residuals must not change.
using ResidualsAt = std::function<Normals(const Eigen::VectorXd&)>;

struct Maximum {
  Eigen::VectorXd value;
  /// Inverse of Fisher's information, with the prior; wider where the likelihood falls less within
  /// the 95 % bound.
  Eigen::MatrixXd covariance;
  int iterations = 0;
  /// The last step was below a hundredth of the bounds, or nothing at the bounds is likelier:
  /// a likelihood with leaps has a maximum at which no slope is zero.
  bool converged = false;
};

/// The most likely values for normal residuals, eq. (S13), from `start` on: Gauss-Newton's method
/// with Fisher's information, in which the sigmas count too. The prior of each is normal about
/// zero; derivatives are differences over `step` of the prior's sigma.
Maximum most_likely(const ResidualsAt& residuals, const Eigen::VectorXd& prior_sigma,
                    const Eigen::VectorXd& start, double step = 1e-3);

}  // namespace drydock::calibration
