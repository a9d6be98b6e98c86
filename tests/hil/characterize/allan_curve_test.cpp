#include "hil/characterize/noise/allan_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hil/sensor/random.hpp"

namespace drydock::characterize {
namespace allan_curve_test {

TEST(AllanModel, IsTheClosedFormOfEachProcess) {
  const double tau = 8;
  EXPECT_NEAR(std::sqrt(NoiseModel{.density = 3}.allan_variance(tau)), 3 / std::sqrt(tau), 1e-12);
  EXPECT_NEAR(std::sqrt(NoiseModel{.walk = 3}.allan_variance(tau)), 3 * std::sqrt(tau / 3), 1e-12);
  EXPECT_NEAR(std::sqrt(NoiseModel{.quantisation = 3}.allan_variance(tau)),
              3 * std::sqrt(3.0) / tau, 1e-12);
  // IEEE 952: the maximum of a Gauss-Markov process is 0.617 sigma, at 1.89 T.
  const NoiseModel markov{.instability = 2, .correlation_s = 10};
  EXPECT_NEAR(std::sqrt(markov.allan_variance(18.9)), 2 * 0.617, 0.002);
  EXPECT_LT(markov.allan_variance(16), markov.allan_variance(18.9));
  EXPECT_LT(markov.allan_variance(22), markov.allan_variance(18.9));
}

TEST(AllanCurve, OfARampAndOfAnAlternationIsExact) {
  std::vector<double> ramp, alternation;
  for (int k = 0; k < 900; ++k) {
    ramp.push_back(0.5 * k);
    alternation.push_back(k % 2 == 0 ? 1 : -1);
  }
  const auto of_ramp = allan_curve(ramp, 0.1), of_alternation = allan_curve(alternation, 0.1);
  ASSERT_EQ(of_ramp.samples.size(), 7U);  // 1 to 64; nine clusters of at most 100 samples
  for (std::size_t i = 0; i < of_ramp.samples.size(); ++i) {
    const auto m = static_cast<double>(of_ramp.samples[i]);
    EXPECT_NEAR(of_ramp.variance[i], m * m / 8, 1e-9 * m * m);
    EXPECT_NEAR(of_alternation.variance[i], m == 1 ? 2 : 0, 1e-12);
  }
  EXPECT_DOUBLE_EQ(of_ramp.tau_s(3), 0.8);
}

/// NIST Special Publication 1065 (Riley, Handbook of Frequency Stability Analysis), table 5, after
/// Howe, Allan and Barnes 1981: degrees of freedom of the overlapping estimate from `points` points
/// of the integral. These approximations are accurate to a few per cent.
double published_white(double points, double m) {
  return (3 * (points - 1) / (2 * m) - 2 * (points - 2) / points) * 4 * m * m / (4 * m * m + 5);
}
double published_walk(double points, double m) {
  return (points - 2) / m * ((points - 1) * (points - 1) - 3 * m * (points - 1) + 4 * m * m) /
         ((points - 3) * (points - 3));
}

TEST(AllanCovariance, HasThePublishedDegreesOfFreedom) {
  const AllanCurve curve{1, 1024, {1, 2, 4, 8, 16, 32, 64}, std::vector<double>(7, 1.0)};
  const NoiseModel white{.density = 1}, walk{.walk = 1};
  const auto of_white = covariance(curve, white), of_walk = covariance(curve, walk);
  for (std::size_t i = 0; i < curve.samples.size(); ++i) {
    const auto m = static_cast<double>(curve.samples[i]);
    const auto k = static_cast<Eigen::Index>(i);
    const double v = white.allan_variance(m), w = walk.allan_variance(m);
    const double expected = published_white(1025, m);
    EXPECT_NEAR(2 * v * v / of_white(k, k), expected, 0.08 * expected) << m;
    if (m < 4) continue;  // the closed form is for a continuous random walk
    EXPECT_NEAR(2 * w * w / of_walk(k, k), published_walk(1025, m), 0.12 * published_walk(1025, m))
        << m;
  }
}

TEST(AllanCovariance, IsTheScatterOfManyRecordingsAndOfNeighbouringPointsTogether) {
  constexpr std::size_t runs = 600, readings = 256;
  sensor::RandomStream random(1, "sensor", "white");
  Eigen::Matrix<double, 5, Eigen::Dynamic> all(5, runs);
  AllanCurve curve;
  for (std::size_t run = 0; run < runs; ++run) {
    std::vector<double> values(readings);
    for (double& value : values) value = random.normal();
    curve = allan_curve(values, 1);
    for (std::size_t i = 0; i < 5; ++i)
      all(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(run)) = curve.variance[i];
  }
  const Eigen::MatrixXd centred = all.colwise() - all.rowwise().mean();
  const Eigen::MatrixXd scatter = centred * centred.transpose() / runs;
  const auto expected = covariance(curve, {.density = 1});
  for (Eigen::Index i = 0; i < 5; ++i) {
    EXPECT_NEAR(scatter(i, i) / expected(i, i), 1, 0.25) << i;
    if (i > 0) {
      const double together = std::sqrt(expected(i, i) * expected(i - 1, i - 1));
      EXPECT_NEAR(scatter(i, i - 1) / together, expected(i, i - 1) / together, 0.12) << i;
    }
  }
}

}  // namespace allan_curve_test
}  // namespace drydock::characterize
