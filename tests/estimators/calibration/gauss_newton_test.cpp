#include "estimators/calibration/gauss_newton.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

namespace drydock::calibration {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

/// Residuals of sigma 1.
Normals white(const VectorXd& residuals) { return {residuals, VectorXd::Ones(residuals.size())}; }

TEST(GaussNewton, OnALinearProblemIsTheClosedFormOfLeastSquaresWithAPrior) {
  MatrixXd a(4, 2);
  a << 1, 2, 3, -1, 0.5, 4, -2, 1;
  const Eigen::Vector4d b{1, 2, -1, 0.5};
  const Vector2d prior{2, 0.5};
  const auto found =
      most_likely([&](const VectorXd& x) { return white(a * x - b); }, prior, Vector2d::Zero());
  MatrixXd information = a.transpose() * a;
  information.diagonal() += prior.cwiseAbs2().cwiseInverse();
  const MatrixXd covariance = information.inverse();
  EXPECT_TRUE(found.converged);
  EXPECT_LT((found.value - covariance * a.transpose() * b).norm(), 1e-9);
  EXPECT_LT((found.covariance - covariance).norm(), 1e-9);
}

TEST(GaussNewton, FindsTheLogarithmThatMakesAnExponentialFit) {
  // exp(x) = 3, measured to 1e-4: x = ln 3, sigma = 1e-4 / 3.
  const auto found = most_likely(
      [](const VectorXd& x) {
        return Normals{VectorXd::Constant(1, std::exp(x(0)) - 3), VectorXd::Constant(1, 1e-4)};
      },
      VectorXd::Constant(1, 10), VectorXd::Zero(1), 1e-8);
  EXPECT_NEAR(found.value(0), std::log(3), 1e-6);
  EXPECT_NEAR(std::sqrt(found.covariance(0, 0)), 1e-4 / 3, 1e-7);
}

/// n normal values whose sigma is exp(x): its most likely value is their RMS. -2 ln rises by
/// n (exp(-2 d) - 1 + 2 d), which is 1.96^2 at d = 0.5849 (and 0.4215 to the steeper side). Without
/// ln sigma in the likelihood the sigma would grow without end.
TEST(GaussNewton, FindsAParameterThatOnlyTheSigmaHas) {
  const VectorXd values = (VectorXd(8) << 1, -2, 3, -1, 2, -3, 1, 2).finished();
  const auto found = most_likely(
      [&](const VectorXd& x) {
        return Normals{values, VectorXd::Constant(values.size(), std::exp(x(0)))};
      },
      VectorXd::Constant(1, 1e4), VectorXd::Zero(1), 1e-8);
  EXPECT_TRUE(found.converged);
  EXPECT_NEAR(found.value(0), std::log(std::sqrt(33.0 / 8)), 1e-4);
  EXPECT_NEAR(1.96 * std::sqrt(found.covariance(0, 0)), 0.5849, 0.01);
}

/// |x| has its minimum at a place where its slope leaps from -1 to 1: no step gets smaller there,
/// and still nothing beside it is likelier.
TEST(GaussNewton, AMaximumWithALeapOfTheSlopeIsSettled) {
  const auto found = most_likely(
      [](const VectorXd& x) {
        return white(VectorXd::Constant(1, std::sqrt(1000 * std::abs(x(0) - 0.3))));
      },
      VectorXd::Constant(1, 10), VectorXd::Zero(1));
  EXPECT_NEAR(found.value(0), 0.3, 0.05);
  EXPECT_TRUE(found.converged);
}

/// A leap just above 0 turns the search away from 10, where it should go.
TEST(GaussNewton, ASearchThatStopsWhereAPlaceBesideItIsLikelierDidNotSettle) {
  const auto found = most_likely(
      [](const VectorXd& x) {
        return white(VectorXd::Constant(1, x(0) > 0 && x(0) < 0.02 ? 20 : 10 - x(0)));
      },
      VectorXd::Constant(1, 10), VectorXd::Zero(1));
  EXPECT_FALSE(found.converged);
}

TEST(GaussNewton, WhatNoResidualTouchesKeepsItsPrior) {
  const auto found =
      most_likely([](const VectorXd& x) { return white(VectorXd::Constant(1, x(0) - 1)); },
                  Vector2d{1e3, 7}, Vector2d::Zero());
  EXPECT_NEAR(found.value(0), 1, 1e-5);
  EXPECT_EQ(found.value(1), 0);
  EXPECT_NEAR(found.covariance(1, 1), 49, 1e-9);
}

/// tanh(10 x) is steep at its most likely value 0 and at most 1 beside it: with the prior's x^2,
/// -2 ln rises by 1.96^2 at sqrt(1.96^2 - 1) = 1.6857.
TEST(GaussNewton, ALikelihoodThatGrowsFlatterBesideItsMaximumHasAWiderBound) {
  const auto found = most_likely(
      [](const VectorXd& x) { return white(VectorXd::Constant(1, std::tanh(10 * x(0)))); },
      VectorXd::Constant(1, 1), VectorXd::Zero(1));
  EXPECT_NEAR(1.96 * std::sqrt(found.covariance(0, 0)), 1.6857, 0.03);
}

/// A residual leaps by 5 just beside the most likely value: that is no slope.
TEST(GaussNewton, ALeapBesideTheMaximumIsNoInformation) {
  for (const double side : {-1.0, 1.0}) {
    const auto found = most_likely(
        [&](const VectorXd& x) {
          return white(Vector2d{3 * x(0), side * x(0) > 5e-4 ? 5.0 : 0.0});
        },
        VectorXd::Constant(1, 1), VectorXd::Zero(1));
    EXPECT_LT(std::abs(found.value(0)), 1e-3);
    EXPECT_GE(std::sqrt(found.covariance(0, 0)), 0.99 / std::sqrt(10.));
  }
}

}  // namespace
}  // namespace drydock::calibration
