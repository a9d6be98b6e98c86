#include "hil/sensor/noise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "hil/sensor/readout.hpp"

/// Compared with the closed forms of IEEE Std 952, annex C. Bounds are four standard errors of the
/// estimate unless a comment says otherwise.
namespace drydock::sensor {
namespace noise_test {

using measurement::stamp_from_ns;
using rig_config::SensorErrors;

constexpr ErrorSource gyro{11, "imu", "primary", true};

/// Allan variance of readings at dt, at tau = m dt, from non-overlapping clusters.
double allan_variance(const std::vector<double>& readings, std::size_t m) {
  const std::size_t clusters = readings.size() / m;
  double sum = 0, last = 0;
  for (std::size_t c = 0; c < clusters; ++c) {
    double mean = 0;
    for (std::size_t i = 0; i < m; ++i) mean += readings[c * m + i] / static_cast<double>(m);
    if (c > 0) sum += (mean - last) * (mean - last);
    last = mean;
  }
  return sum / (2 * static_cast<double>(clusters - 1));
}

/// Relative standard error of that estimate. It treats the differences of clusters as independent
/// and adds a small allowance, because they are not.
double allan_error(std::size_t readings, std::size_t m) {
  return std::sqrt(3 / static_cast<double>(readings / m));
}

std::vector<double> white(double density, double rate_hz, std::size_t n) {
  SensorErrors errors;
  errors.noise_density = {density, 0, 0};
  WhiteNoise noise(errors, rate_hz, gyro);
  std::vector<double> readings(n);
  for (double& reading : readings) reading = noise.next(1).x();
  return readings;
}

std::vector<double> drift(const SensorErrors& errors, double rate_hz, std::size_t n) {
  Drift process(errors, gyro);
  std::vector<double> readings(n);
  for (std::size_t k = 0; k < n; ++k)
    readings[k] =
        process.at(Stamp{measurement::from_seconds(static_cast<double>(k) / rate_hz)}, 1).x();
  return readings;
}

TEST(AllanVariance, OfAnAngleRandomWalkFallsAsOneOverTauAtAnyRate) {
  constexpr double n2 = 0.3 * 0.3;
  for (const double rate_hz : {100.0, 10.0}) {
    const auto readings = white(0.3, rate_hz, 200'000);
    for (const std::size_t m : {1U, 10U, 100U, 1000U}) {
      const double expected = n2 / (static_cast<double>(m) / rate_hz);
      EXPECT_NEAR(allan_variance(readings, m), expected,
                  4 * expected * allan_error(readings.size(), m))
          << rate_hz << " Hz, " << m << " samples";
    }
  }
}

TEST(AllanVariance, OfARateRandomWalkGrowsAsAThirdOfTauAtAnyRate) {
  SensorErrors errors;
  errors.random_walk = {0.2, 0, 0};
  for (const double rate_hz : {100.0, 10.0}) {
    const auto readings = drift(errors, rate_hz, 400'000);
    for (const std::size_t m : {20U, 200U, 2000U}) {
      // K^2 tau / 3 is for a continuous walk. A sampled walk has (1 + 1 / (2 m^2)) times that.
      const double expected = 0.04 * static_cast<double>(m) / rate_hz / 3;
      EXPECT_NEAR(allan_variance(readings, m), expected,
                  4 * expected * allan_error(readings.size(), m))
          << rate_hz << " Hz, " << m << " samples";
    }
  }
}

TEST(AllanVariance, OfAGaussMarkovProcessHasItsHumpWhereTheStandardHasIt) {
  constexpr double sigma = 0.5, correlation_s = 10, rate_hz = 10;
  SensorErrors errors;
  errors.bias_instability = {sigma, 0, 0};
  errors.correlation_s = correlation_s;
  const auto readings = drift(errors, rate_hz, 1'000'000);
  for (const std::size_t m : {20U, 189U, 1000U}) {
    const double x = static_cast<double>(m) / rate_hz / correlation_s;  // tau / T
    const double expected =
        2 * sigma * sigma / x * (1 - (3 - 4 * std::exp(-x) + std::exp(-2 * x)) / (2 * x));
    EXPECT_NEAR(allan_variance(readings, m), expected,
                4 * expected * allan_error(readings.size(), m) + 2e-3 * expected)
        << m;
  }
  EXPECT_NEAR(std::sqrt(allan_variance(readings, 189)), 0.617 * sigma, 0.02);
}

TEST(AllanVariance, OfCarriedQuantisationFallsAsOneOverTauSquared) {
  SensorErrors errors;
  errors.quantisation = {1, 0, 0};
  errors.quantisation_carried = true;
  Readout readout(errors);
  RandomStream input(3, "imu", "input");
  std::vector<double> readings(200'000);
  for (double& reading : readings) {
    const double ideal = 20 * input.uniform();
    reading = readout.of({ideal, 0, 0}).x() - ideal;
  }
  // The error of each cluster's sum is the difference of two remainders, uniform within half a
  // step: sigma^2(tau) = 3 Q^2 / tau^2 with Q^2 = q^2 / 12 in steps of samples.
  for (const std::size_t m : {1U, 10U, 100U}) {
    const double expected = 3 / 12.0 / static_cast<double>(m * m);
    EXPECT_NEAR(allan_variance(readings, m), expected,
                4 * expected * allan_error(readings.size(), m));
  }
}

struct Ensemble {
  double variance = 0, covariance = 0;  ///< at the end, and with an earlier time
};

/// Over 20 000 runs: after 4 s in steps of 1 / rate, and `lag_s` later.
Ensemble ensemble(const SensorErrors& errors, double rate_hz, double lag_s) {
  constexpr int runs = 20'000;
  Ensemble result;
  for (std::uint64_t seed = 0; seed < runs; ++seed) {
    Drift process(errors, {seed, "imu", "primary", true});
    double before = 0;
    for (int k = 0; k <= 4 * rate_hz; ++k)
      before = process.at(Stamp{measurement::from_seconds(k / rate_hz)}, 1).x();
    const double after = process.at(Stamp{measurement::from_seconds(4 + lag_s)}, 1).x();
    result.variance += before * before / runs;
    result.covariance += before * after / runs;
  }
  return result;
}

TEST(BiasInstability, IsStationaryAndForgetsExponentiallyWhateverTheRate) {
  SensorErrors errors;
  errors.bias_instability = {2, 0, 0};
  errors.correlation_s = 3;
  for (const double rate_hz : {5.0, 1.0}) {
    const auto found = ensemble(errors, rate_hz, 1.5);
    EXPECT_NEAR(found.variance, 4, 4 * 4 * std::sqrt(2 / 20'000.0)) << rate_hz;
    EXPECT_NEAR(found.covariance, 4 * std::exp(-0.5), 4 * 4 * std::sqrt(1.4 / 20'000.0)) << rate_hz;
  }
}

TEST(RandomWalk, VarianceGrowsWithTimeWhateverTheRate) {
  SensorErrors errors;
  errors.random_walk = {0.5, 0, 0};
  for (const double rate_hz : {5.0, 1.0}) {
    const auto found = ensemble(errors, rate_hz, 10);
    EXPECT_NEAR(found.variance, 0.25 * 4, 4 * std::sqrt(2 / 20'000.0)) << rate_hz;
    // Increments are independent, so 10 s later the covariance equals the earlier variance.
    EXPECT_NEAR(found.covariance, 1, 4 * std::sqrt((3.5 + 1) / 20'000.0)) << rate_hz;
  }
}

}  // namespace noise_test
}  // namespace drydock::sensor
