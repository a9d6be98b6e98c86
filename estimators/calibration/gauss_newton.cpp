#include "estimators/calibration/gauss_newton.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

namespace drydock::calibration {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int most_iterations = 12, most_halvings = 5;
constexpr double small_step = 0.01;  ///< of the bounds
constexpr double bound_95 = 1.96;    ///< sigmas
constexpr double widening = 1.25;    ///< steps of the search for a bound
constexpr double rounded = 0.999;    ///< a rise that rounding made a little smaller

/// Derivatives of the whitened residuals at fixed sigma, and of ln sigma.
struct Slopes {
  MatrixXd residual, log_sigma;
};

/// Everything in units of the prior's sigma.
struct Problem {
  const ResidualsAt& residuals;
  const VectorXd& sigma;

  Normals at(const VectorXd& x) const { return residuals(sigma.cwiseProduct(x)); }
  static VectorXd whitened(const Normals& n) { return n.residual.cwiseQuotient(n.sigma); }
  /// -2 ln of the likelihood and the prior, up to a constant.
  static double cost(const Normals& n, const VectorXd& x) {
    return whitened(n).squaredNorm() + 2 * n.sigma.array().log().sum() + x.squaredNorm();
  }
  Slopes slopes(const VectorXd& x, const Normals& here, double step) const {
    Slopes slopes{MatrixXd(here.residual.size(), x.size()), MatrixXd(here.sigma.size(), x.size())};
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      const Normals there = at(x + step * VectorXd::Unit(x.size(), i));
      slopes.residual.col(i) = (there.residual - here.residual).cwiseQuotient(here.sigma) / step;
      slopes.log_sigma.col(i) = (there.sigma - here.sigma).cwiseQuotient(here.sigma) / step;
    }
    return slopes;
  }
};

/// Half the derivative of the cost.
VectorXd gradient(const Slopes& slopes, const Normals& n, const VectorXd& x) {
  const VectorXd white = Problem::whitened(n);
  const VectorXd excess = 1 - white.array().square();
  return slopes.residual.transpose() * white + slopes.log_sigma.transpose() * excess + x;
}

/// Of the slopes to both sides, for each number those of the smoother side: where a latency is such
/// that two sensors' readings change their order, residuals of one are suddenly those of the other,
/// and a step across that place finds slopes that are no information.
Slopes smoother_of(Slopes slopes, const Slopes& other) {
  for (Eigen::Index i = 0; i < slopes.residual.cols(); ++i) {
    const auto size = [i](const Slopes& s) {
      return s.residual.col(i).squaredNorm() + 2 * s.log_sigma.col(i).squaredNorm();
    };
    if (size(slopes) <= size(other)) continue;
    slopes.residual.col(i) = other.residual.col(i);
    slopes.log_sigma.col(i) = other.log_sigma.col(i);
  }
  return slopes;
}

/// The inverse of Fisher's information: each residual e has that of its mean, and of its sigma
/// 2 (d ln sigma)2.
MatrixXd covariance_of(const Slopes& slopes) {
  const auto count = slopes.residual.cols();
  const MatrixXd unit = MatrixXd::Identity(count, count);
  const MatrixXd information = slopes.residual.transpose() * slopes.residual +
                               2 * slopes.log_sigma.transpose() * slopes.log_sigma + unit;
  return information.llt().solve(unit);
}

/// What lies beside the maximum.
struct Beside {
  VectorXd wider;       ///< factor on each bound
  bool better = false;  ///< somewhere
};

/// How far the 95 % bound of each number is from the maximum, in units of that of a likelihood with
/// constant curvature: -2 ln rises by 1.96 squared there (S. S. Wilks, 1938), on the ridge along
/// which the other numbers follow. The farther side counts, and never less than 1: readings of a
/// latency that almost come at once give slopes that no longer hold a tenth of a second beside.
Beside look_beside(const Problem& problem, const VectorXd& x, double cost,
                   const MatrixXd& covariance) {
  constexpr double limit = bound_95 * bound_95;
  Beside found{VectorXd(x.size())};
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const VectorXd ridge = covariance.col(i) / std::sqrt(covariance(i, i));
    const auto rise_at = [&](double sigmas) {
      const VectorXd beside = x + sigmas * ridge;
      const double rise = Problem::cost(problem.at(beside), beside) - cost;
      found.better |= rise < 0;
      return rise;
    };
    double farthest = bound_95;
    for (const double side : {-1.0, 1.0}) {
      double at = bound_95, rise = rise_at(side * at);
      // The prior alone rises by the limit before the bound is that of the prior.
      while (rise < rounded * limit && at * std::sqrt(covariance(i, i)) < bound_95) {
        const double before = at, risen = rise;
        at *= widening;
        rise = rise_at(side * at);
        if (rise > limit) at = before + (at - before) * (limit - risen) / (rise - risen);
      }
      farthest = std::max(farthest, at);
    }
    found.wider(i) = farthest / bound_95;
  }
  return found;
}

}  // namespace

Maximum most_likely(const ResidualsAt& residuals, const VectorXd& prior_sigma,
                    const VectorXd& start, double step) {
  const Problem problem{residuals, prior_sigma};
  VectorXd x = start.cwiseQuotient(prior_sigma);
  Normals here = problem.at(x);
  Maximum result;
  MatrixXd covariance;
  while (result.iterations < most_iterations && !result.converged) {
    ++result.iterations;
    const Slopes slopes = problem.slopes(x, here, step);
    covariance = covariance_of(slopes);
    VectorXd change = -covariance * gradient(slopes, here, x);
    const double before = Problem::cost(here, x);
    Normals next = problem.at(x + change);
    for (int i = 0; i < most_halvings && Problem::cost(next, x + change) > before; ++i) {
      change /= 2;
      next = problem.at(x + change);
    }
    result.converged =
        (change.cwiseAbs().array() < small_step * covariance.diagonal().array().sqrt()).all();
    if (Problem::cost(next, x + change) > before) break;  // rounding: it gets no better
    x += change;
    here = next;
  }
  covariance =
      covariance_of(smoother_of(problem.slopes(x, here, step), problem.slopes(x, here, -step)));
  const auto beside = look_beside(problem, x, Problem::cost(here, x), covariance);
  result.converged |= !beside.better;
  covariance = beside.wider.asDiagonal() * covariance * beside.wider.asDiagonal();
  result.value = prior_sigma.cwiseProduct(x);
  result.covariance = prior_sigma.asDiagonal() * covariance * prior_sigma.asDiagonal();
  return result;
}

}  // namespace drydock::calibration
