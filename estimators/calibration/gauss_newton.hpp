#pragma once

#include <Eigen/Core>
#include <functional>

namespace drydock::calibration {

/// Residuals in units of their own sigma, at values of the parameters. Their number must not
/// change.
using Whitened = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

struct Maximum {
  Eigen::VectorXd value;
  Eigen::MatrixXd covariance;  ///< inverse of the Hessian, with the prior
  int iterations = 0;
  bool converged = false;  ///< the last step was below a hundredth of the bounds
};

/// The most likely values for whitened residuals, eq. (S13), from `start` on. The prior of each is
/// normal about zero; derivatives are differences over `step` of the prior's sigma.
Maximum most_likely(const Whitened& residuals, const Eigen::VectorXd& prior_sigma,
                    const Eigen::VectorXd& start, double step = 1e-3);

}  // namespace drydock::calibration
