#include "hil/sensor/errors.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace drydock::sensor {
namespace errors_test {

using measurement::stamp_from_ns;
using rig_config::SensorErrors;

constexpr double rate_hz = 100;
Stamp sample_time(int k) { return stamp_from_ns(k * 10'000'000LL); }

ErrorSource source(bool fixed, std::uint64_t seed = 7) { return {seed, "imu", "primary", fixed}; }

SensorErrors bias_and_noise() {
  SensorErrors errors;
  errors.bias = {0.1, -0.2, 0.3};
  errors.noise = {1, 2, 3};
  return errors;
}

TEST(Errors, AFixedBiasIsOneSigmaAsGiven) {
  const ErrorModel model(bias_and_noise(), rate_hz, source(true));
  EXPECT_EQ(model.bias(), Vector3d(0.1, -0.2, 0.3));
}

TEST(Errors, ADrawnBiasHasTheGivenSpreadOverManySeeds) {
  double sum = 0, squares = 0;
  constexpr int n = 20'000;
  for (std::uint64_t seed = 0; seed < n; ++seed) {
    const double z = ErrorModel(bias_and_noise(), rate_hz, source(false, seed)).bias().z();
    sum += z / n;
    squares += z * z / n;
  }
  EXPECT_NEAR(sum, 0, 4 * 0.3 / std::sqrt(n));
  EXPECT_NEAR(squares, 0.09, 4 * 0.09 * std::sqrt(2.0 / n));
}

TEST(Errors, NoiseIsWhiteWithTheGivenDeviationPerAxis) {
  ErrorModel model(bias_and_noise(), rate_hz, source(true));
  constexpr int n = 50'000;
  Vector3d mean = Vector3d::Zero(), squares = mean, lagged = mean, last = mean;
  for (int i = 0; i < n; ++i) {
    const Vector3d e = model.apply(Vector3d::Zero(), sample_time(i)) - model.bias();
    mean += e / n;
    squares += e.cwiseProduct(e) / n;
    lagged += e.cwiseProduct(last) / n;
    last = e;
  }
  for (int axis = 0; axis < 3; ++axis) {
    const double sigma = axis + 1;
    EXPECT_NEAR(mean[axis], 0, 4 * sigma / std::sqrt(n));
    EXPECT_NEAR(squares[axis], sigma * sigma, 4 * sigma * sigma * std::sqrt(2.0 / n));
    EXPECT_NEAR(lagged[axis], 0, 4 * sigma * sigma / std::sqrt(n));
  }
}

TEST(Errors, WithoutErrorsNothingChanges) {
  ErrorModel model({}, rate_hz, source(false));
  EXPECT_EQ(model.apply(1.25, sample_time(0)), 1.25);
}

// The mixing paper's gyro at 200 deg/s, in deg/s: 600 ppm, 100 ppm between the signs, 2 ppm per
// deg/s.
TEST(Errors, ScaleFactorItsAsymmetryAndItsNonlinearityByHand) {
  SensorErrors errors;
  errors.scale_factor = {600e-6, 0, 0};
  ErrorModel scale(errors, rate_hz, source(true));
  EXPECT_NEAR(scale.apply(200, sample_time(0)), 200.12, 1e-12);
  EXPECT_NEAR(scale.apply(-200, sample_time(1)), -200.12, 1e-12);
  errors = {};
  errors.asymmetry = {100e-6, 0, 0};
  ErrorModel asymmetry(errors, rate_hz, source(true));
  EXPECT_NEAR(asymmetry.apply(200, sample_time(0)), 200.01, 1e-12);
  EXPECT_NEAR(asymmetry.apply(-200, sample_time(1)), -199.99, 1e-12);
  errors = {};
  errors.nonlinearity = {2e-6, 0, 0};
  ErrorModel bent(errors, rate_hz, source(true));
  EXPECT_NEAR(bent.apply(200, sample_time(0)), 200.08, 1e-12);
  EXPECT_NEAR(bent.apply(-200, sample_time(1)), -199.92, 1e-12);
}

TEST(Errors, AMisalignedAxisFeelsAThousandthOfTheOtherTwo) {
  SensorErrors errors;
  errors.misalignment = {1e-3, 0, 2e-3};
  ErrorModel model(errors, rate_hz, source(true));
  const Vector3d reading = model.apply({10, 20, 40}, sample_time(0));
  EXPECT_NEAR((reading - Vector3d(10.06, 20, 40.06)).norm(), 0, 1e-12);
}

TEST(Errors, AnAxisIsMisalignedTowardTheOthersIndependently) {
  SensorErrors errors;
  errors.misalignment = {1, 0, 0};
  constexpr int n = 20'000;
  double product = 0, square = 0;
  for (std::uint64_t seed = 0; seed < n; ++seed) {
    ErrorModel model(errors, rate_hz, source(false, seed));
    const double toward_y = model.apply(Vector3d::UnitY(), sample_time(0)).x();
    const double toward_z = model.apply(Vector3d::UnitZ(), sample_time(1)).x();
    product += toward_y * toward_z / n;
    square += toward_z * toward_z / n;
  }
  EXPECT_NEAR(product, 0, 4 / std::sqrt(n));
  EXPECT_NEAR(square, 1, 4 * std::sqrt(2.0 / n));
}

SensorErrors all_parts() {
  SensorErrors errors = bias_and_noise();
  errors.scale_factor = errors.asymmetry = errors.nonlinearity = {1e-3, 2e-3, 3e-3};
  errors.misalignment = {1e-3, 1e-3, 1e-3};
  errors.noise_density = errors.bias_instability = errors.random_walk = {0.3, 0.2, 0.1};
  errors.quantisation = {0.01, 0.01, 0.01};
  return errors;
}

TEST(Errors, TheSameSeedGivesTheSameBits) {
  ErrorModel a(all_parts(), rate_hz, source(false)), b(all_parts(), rate_hz, source(false));
  for (int k = 0; k < 1000; ++k) {
    const Vector3d ideal(std::sin(k), 2, -1);
    ASSERT_EQ(a.apply(ideal, sample_time(k)), b.apply(ideal, sample_time(k)));
  }
}

TEST(Errors, OnePartsNumbersDoNotDependOnAnothersBeingThere) {
  SensorErrors white, slow, both;
  white.noise = both.noise = {1, 2, 3};
  slow.bias_instability = both.bias_instability = {1, 1, 1};
  slow.random_walk = both.random_walk = {1, 1, 1};
  both.bias = {5, 5, 5};
  ErrorModel noise(white, rate_hz, source(false)), drift(slow, rate_hz, source(false)),
      sum(both, rate_hz, source(false));
  for (int k = 0; k < 1000; ++k) {
    const Vector3d apart = noise.apply(Vector3d::Zero(), sample_time(k)) +
                           drift.apply(Vector3d::Zero(), sample_time(k)) + sum.bias();
    ASSERT_NEAR((sum.apply(Vector3d::Zero(), sample_time(k)) - apart).norm(), 0, 1e-12);
  }
}

}  // namespace errors_test
}  // namespace drydock::sensor
