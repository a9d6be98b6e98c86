#include "estimators/calibration/gauss_newton.hpp"

#include <Eigen/Cholesky>

namespace drydock::calibration {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int most_iterations = 12, most_halvings = 5;
constexpr double small_step = 0.01;  ///< of the bounds

/// Everything in units of the prior's sigma.
struct Problem {
  const Whitened& residuals;
  const VectorXd& sigma;

  VectorXd at(const VectorXd& x) const { return residuals(sigma.cwiseProduct(x)); }
  double cost(const VectorXd& r, const VectorXd& x) const {
    return r.squaredNorm() + x.squaredNorm();
  }
  MatrixXd slopes(const VectorXd& x, const VectorXd& here, double step) const {
    MatrixXd j(here.size(), x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i)
      j.col(i) = (at(x + step * VectorXd::Unit(x.size(), i)) - here) / step;
    return j;
  }
};

}  // namespace

Maximum most_likely(const Whitened& residuals, const VectorXd& prior_sigma, const VectorXd& start,
                    double step) {
  const Problem problem{residuals, prior_sigma};
  VectorXd x = start.cwiseQuotient(prior_sigma), r = problem.at(x);
  Maximum result;
  MatrixXd covariance;
  while (result.iterations < most_iterations && !result.converged) {
    ++result.iterations;
    const MatrixXd j = problem.slopes(x, r, step);
    const MatrixXd information =
        j.transpose() * j + MatrixXd::Identity(prior_sigma.size(), prior_sigma.size());
    covariance = information.llt().solve(MatrixXd::Identity(x.size(), x.size()));
    VectorXd change = -covariance * (j.transpose() * r + x);
    const double before = problem.cost(r, x);
    VectorXd next = problem.at(x + change);
    for (int i = 0; i < most_halvings && problem.cost(next, x + change) > before; ++i) {
      change /= 2;
      next = problem.at(x + change);
    }
    result.converged =
        (change.cwiseAbs().array() < small_step * covariance.diagonal().array().sqrt()).all();
    if (problem.cost(next, x + change) > before) break;  // rounding: it gets no better
    x += change;
    r = next;
  }
  result.value = prior_sigma.cwiseProduct(x);
  result.covariance = prior_sigma.asDiagonal() * covariance * prior_sigma.asDiagonal();
  return result;
}

}  // namespace drydock::calibration
