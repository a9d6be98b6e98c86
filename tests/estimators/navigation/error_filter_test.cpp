#include "estimators/navigation/error_filter.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace drydock::navigation {
namespace {

template <int Further>
typename ErrorFilter<Further>::Vector random_vector(std::mt19937_64& random) {
  std::uniform_real_distribution<double> one(-1, 1);
  typename ErrorFilter<Further>::Vector v = ErrorFilter<Further>::Vector::Zero();
  for (int i = 0; i < ErrorFilter<Further>::size; ++i) v(i) = one(random);
  return v;
}

ErrorDynamics random_dynamics(std::mt19937_64& random) {
  std::uniform_real_distribution<double> one(-1, 1);
  ErrorDynamics f = ErrorDynamics::Zero();
  for (std::size_t row = 0; row < 9; ++row)
    for (int i = 0; i < error_dynamics_pattern[row].entries; ++i)
      f(static_cast<int>(row), error_dynamics_pattern[row].columns[static_cast<std::size_t>(i)]) =
          one(random);
  return f;
}

/// A filter with a full covariance.
template <int Further>
ErrorFilter<Further> correlated(std::mt19937_64& random) {
  ErrorFilter<Further> filter(random_vector<Further>(random).cwiseAbs());
  for (int i = 0; i < 6; ++i) filter.update(filter.row(random_vector<Further>(random), 0.3), 0);
  return filter;
}

template <int Further>
void expect_propagation_as_by_full_matrices() {
  std::mt19937_64 random(1);
  using Filter = ErrorFilter<Further>;
  Filter filter = correlated<Further>(random);
  const ErrorDynamics f = random_dynamics(random);
  const auto noise = random_vector<Further>(random).cwiseAbs().eval();
  const double dt = 0.1;
  Eigen::MatrixXd transition = Eigen::MatrixXd::Identity(Filter::stored, Filter::stored);
  transition.topLeftCorner<9, 15>() += f * dt;
  const Eigen::MatrixXd noise_matrix = (noise * dt).asDiagonal();
  const Eigen::MatrixXd expected =
      transition * filter.covariance() * transition.transpose() + noise_matrix;
  filter.propagate(f, dt, noise);
  EXPECT_LT((filter.covariance() - expected).norm(), 1e-13);
  EXPECT_EQ(filter.covariance(), filter.covariance().transpose());
}

TEST(ErrorFilter, PropagatesAsTheFullMatricesDo) {
  expect_propagation_as_by_full_matrices<0>();
  expect_propagation_as_by_full_matrices<7>();
}

TEST(ErrorFilter, UpdatesAsJosephsFormByFullMatrices) {
  std::mt19937_64 random(2);
  auto filter = correlated<3>(random);
  using Filter = ErrorFilter<3>;
  const Eigen::MatrixXd p = filter.covariance();
  const Filter::Vector h = random_vector<3>(random);
  const double r = 0.7, s = h.dot(p * h) + r;
  const Eigen::VectorXd gain = p * h / s;
  const Eigen::MatrixXd kept =
      Eigen::MatrixXd::Identity(Filter::stored, Filter::stored) - gain * h.transpose();
  const Eigen::MatrixXd expected = kept * p * kept.transpose() + r * gain * gain.transpose();
  const auto row = filter.row(h, r);
  EXPECT_NEAR(row.variance, s, 1e-14);
  const Filter::Vector errors = filter.update(row, 2);
  EXPECT_LT((errors - 2 * gain).norm(), 1e-14);
  EXPECT_LT((filter.covariance() - expected).norm(), 1e-14);
}

TEST(ErrorFilter, StaysSymmetricAndPositiveThroughManyNearlyExactMeasurements) {
  std::mt19937_64 random(3);
  auto filter = correlated<0>(random);
  const ErrorDynamics f = random_dynamics(random);
  const auto noise = (1e-6 * ErrorFilter<0>::Vector::Ones()).eval();
  for (int i = 0; i < 4000; ++i) {
    filter.propagate(f, 1e-3, noise);
    filter.update(filter.row(ErrorFilter<0>::Vector::Unit(i % 9), 1e-12), 0);
  }
  EXPECT_EQ(filter.covariance(), filter.covariance().transpose());
  const Eigen::MatrixXd p = filter.covariance().topLeftCorner<15, 15>();
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(p).eigenvalues().minCoeff(), 0);
}

}  // namespace
}  // namespace drydock::navigation
