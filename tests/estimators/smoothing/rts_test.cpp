#include "estimators/smoothing/rts.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <random>

namespace drydock::smoothing {
namespace {

using Matrix2 = Eigen::Matrix2d;
using Vector2 = Eigen::Vector2d;

/// A mass on a line that white acceleration moves; its place is measured each second. Units of the
/// second state are chosen so that the scaling matters.
struct Line {
  static constexpr int epochs = 40;
  double unit = 1;  ///< velocity is kept in m/s times this
  std::vector<RtsStep<2>> steps;
  std::vector<Vector2> states;
  std::vector<double> places;
  Matrix2 a, q, p0;
  double r = 0.25;

  explicit Line(double velocity_unit) : unit(velocity_unit) {
    a << 1, 1 / unit, 0, 1;
    q << 0.01 / 3, 0.005 * unit, 0.005 * unit, 0.01 * unit * unit;
    p0 << 4, 0, 0, unit * unit;
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    for (int k = 0; k < epochs; ++k) places.push_back(0.3 * k + std::sin(0.2 * k) + normal(random));
    filter();
  }

  void filter() {
    Vector2 x = Vector2::Zero();
    Matrix2 p = p0;
    for (int k = 0; k < epochs; ++k) {
      RtsStep<2> step;
      step.transition = a;
      if (k > 0) {
        x = a * x;
        p = Matrix2(a * p * a.transpose() + q);
      }
      step.predicted = p;
      const Vector2 gain = p.col(0) / (p(0, 0) + r);
      step.correction = gain * (places[static_cast<std::size_t>(k)] - x(0));
      x += step.correction;
      p -= Matrix2(gain * p.row(0));
      step.filtered = p;
      steps.push_back(step);
      states.push_back(x);
    }
  }

  /// The same problem as one least-squares problem in all states: mean and covariance.
  std::pair<Eigen::VectorXd, Eigen::MatrixXd> batch() const {
    Eigen::MatrixXd information = Eigen::MatrixXd::Zero(2 * epochs, 2 * epochs);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(2 * epochs);
    information.topLeftCorner<2, 2>() += p0.inverse();
    Eigen::Matrix<double, 2, 4> link;
    link << -a, Matrix2::Identity();
    for (int k = 0; k < epochs; ++k) {
      information(2 * k, 2 * k) += 1 / r;
      right(2 * k) += places[static_cast<std::size_t>(k)] / r;
      if (k > 0)
        information.block<4, 4>(2 * k - 2, 2 * k - 2) += link.transpose() * q.inverse() * link;
    }
    const Eigen::MatrixXd covariance = information.inverse();
    return {covariance * right, covariance};
  }
};

TEST(Rts, EqualsLeastSquaresOverAllEpochsAtOnce) {
  const Line line(1);
  const auto [mean, covariance] = line.batch();
  const auto results = smooth<2>(std::span<const RtsStep<2>>(line.steps));
  for (int k = 0; k < Line::epochs; ++k) {
    const auto i = static_cast<std::size_t>(k);
    EXPECT_LT((line.states[i] + results[i].correction - mean.segment<2>(2 * k)).norm(), 1e-10);
    EXPECT_LT((results[i].covariance - covariance.block<2, 2>(2 * k, 2 * k)).norm(), 1e-10);
  }
}

TEST(Rts, DoesNotMindStatesOfVeryDifferentSize) {
  const Line plain(1), tiny(1e-9);
  const auto expected = smooth<2>(std::span<const RtsStep<2>>(plain.steps));
  const auto results = smooth<2>(std::span<const RtsStep<2>>(tiny.steps));
  for (std::size_t k = 0; k < expected.size(); ++k) {
    EXPECT_NEAR(results[k].correction(0), expected[k].correction(0), 1e-9);
    EXPECT_NEAR(results[k].correction(1) * 1e9, expected[k].correction(1), 1e-9);
    EXPECT_NEAR(results[k].covariance(1, 1) * 1e18, expected[k].covariance(1, 1), 1e-9);
  }
}

TEST(Rts, TheCovarianceIsNeverAboveTheFilters) {
  const Line line(1);
  const auto results = smooth<2>(std::span<const RtsStep<2>>(line.steps));
  double least = 1;
  for (std::size_t k = 0; k < results.size(); ++k) {
    const Matrix2 gained = line.steps[k].filtered - results[k].covariance;
    least = std::min(least, gained.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff());
  }
  EXPECT_GT(least, -1e-12);
  EXPECT_LT(results[20].covariance(0, 0), 0.7 * line.steps[20].filtered(0, 0));
}

TEST(Rts, AStateWithoutVarianceStaysAsItIs) {
  std::vector<RtsStep<2>> steps(3);
  for (auto& step : steps) {
    step.transition.setIdentity();
    step.predicted = Vector2{2, 0}.asDiagonal();
    step.filtered = Vector2{1, 0}.asDiagonal();
    step.correction = Vector2{0.5, 0};
  }
  for (const auto& result : smooth<2>(std::span<const RtsStep<2>>(steps))) {
    EXPECT_TRUE(result.correction.allFinite());
    EXPECT_EQ(result.correction(1), 0);
    EXPECT_EQ(result.covariance(1, 1), 0);
  }
}

TEST(Rts, NoEpochsGiveNoResults) { EXPECT_TRUE(smooth<2>(std::span<const RtsStep<2>>()).empty()); }

}  // namespace
}  // namespace drydock::smoothing
