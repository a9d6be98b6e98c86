#include "hil/sensor/imu_errors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "rig_config/load.hpp"

namespace drydock::sensor {
namespace imu_errors_test {

using measurement::ImuSample;
using measurement::stamp_from_ns;

constexpr double degree = std::numbers::pi / 180, degph = degree / 3600, g = 9.80665;

rig_config::EmulateConfig grade(const std::string& name) {
  return rig_config::load_sensor(DRYDOCK_SOURCE_DIR "/rig_config/sensors/" + name,
                                 rig_config::DeviceKind::imu)
      .value();
}

ImuSample ideal(const Vector3d& rate, const Vector3d& force) {
  ImuSample sample;
  sample.angular_rate = rate;
  sample.specific_force = force;
  return sample;
}

/// The mixing paper's Table 5 with every constant at +1 sigma and without white noise.
rig_config::EmulateConfig table_5() {
  auto config = grade("mixing-paper.toml");
  config.fixed_bias = true;
  config.primary.noise = config.secondary.noise = {};
  return config;
}

TEST(ImuErrors, OfTable5AtRestLevelByHand) {
  ImuErrors errors(table_5(), 100, 1, "imu");
  const auto reading = errors.apply(ideal(Vector3d::Zero(), {0, 0, -g}));
  // Gyro, deg/h: bias 10; x is sensitive along its spin axis, z: -5; z along its input axis: -5; no
  // product of two axes.
  EXPECT_NEAR((reading.angular_rate / degph - Vector3d(5, 10, 5)).norm(), 0, 1e-9);
  // Accelerometer, g: bias 2e-3; x and y pick up 1e-3 of z; z: -1 (1 + 6e-4) + 0.5e-4 + 7.5e-6.
  EXPECT_NEAR((reading.specific_force / g -
               Vector3d(2e-3 - 1e-3, 2e-3 - 1e-3, -1 + 2e-3 - 6e-4 + 0.5e-4 + 7.5e-6))
                  .norm(),
              0, 1e-12);
}

TEST(ImuErrors, OfTable5TurningUnderLoadByHand) {
  ImuErrors errors(table_5(), 100, 1, "imu");
  const Vector3d rate(10, 0, -30), force(0.5, 0, -1);  // deg/s, g
  const auto reading = errors.apply(ideal(rate * degree, force * g));
  // Gyro x, deg/h: bias 10, unbalance 5 (0.5 - 1), anisoelastic 0.5 * -1; deg/s: scale 6e-4 * 10,
  // asymmetry 0.5e-4 * 10, non-linearity 2e-6 * 100, misalignment 1e-3 (0 - 30).
  EXPECT_NEAR(reading.angular_rate.x() / degree - 10,
              (10 - 2.5 - 0.5) / 3600 + 6e-3 + 5e-4 + 2e-4 - 0.03, 1e-12);
  // Accelerometer x, g: bias 2e-3; rate about y 0; anisoelastic 3e-5 * 0.5 * -1; scale 6e-4 * 0.5;
  // asymmetry 0.5e-4 * 0.5; non-linearity 7.5e-6 * 0.25; misalignment 1e-3 (0 - 1).
  EXPECT_NEAR(reading.specific_force.x() / g - 0.5, 2e-3 - 1.5e-5 + 3e-4 + 2.5e-5 + 1.875e-6 - 1e-3,
              1e-12);
  // Accelerometer y: bias 2e-3; rotation about z, its output axis: 1e-4 * -30; misalignment 1e-3
  // (0.5 - 1).
  EXPECT_NEAR(reading.specific_force.y() / g, 2e-3 - 3e-3 - 5e-4, 1e-12);
}

TEST(ImuErrors, OfTable5DrawnPerRunHaveItsSpread) {
  const auto config = grade("mixing-paper.toml");
  ASSERT_FALSE(config.fixed_bias);
  constexpr int n = 10'000;
  double square = 0;
  for (std::uint64_t run = 0; run < n; ++run) {
    ImuErrors errors(config, 100, run, "imu");
    const double y = errors.apply(ideal(Vector3d::Zero(), Vector3d::Zero())).angular_rate.y();
    square += y * y / n;
  }
  const double variance = std::pow(10 * degph, 2) + std::pow(0.25 * degree, 2);
  EXPECT_NEAR(square, variance, 4 * variance * std::sqrt(2.0 / n));
}

TEST(ImuErrors, OfTheVelocityFilterPaperWalkBySquareRootOfTime) {
  auto config = grade("velocity-filter-paper.toml");
  ASSERT_EQ(config.rate_hz, 10);
  config.primary.bias = {};
  constexpr int runs = 1000, samples = 360;  // a hundredth of an hour
  double square = 0;
  for (std::uint64_t run = 0; run < runs; ++run) {
    ImuErrors errors(config, 10, run, "sdins");
    double angle = 0;
    for (int k = 0; k < samples; ++k)
      angle += errors.apply(ideal(Vector3d::Zero(), Vector3d::Zero())).angular_rate.x() / 10;
    square += angle * angle / runs;
  }
  const double expected = std::pow(0.0004 * degree, 2) / 100;  // 0.4 mdeg/sqrt(h)
  EXPECT_NEAR(square, expected, 4 * expected * std::sqrt(2.0 / runs));
}

TEST(ImuErrors, GyroAndAccelerometerAreIndependentAndEachRunIsAnother) {
  const auto config = grade("xsens-mti-630.toml");
  ImuErrors errors(config, 100, 1, "imu"), again(config, 100, 1, "imu"),
      other(config, 100, 2, "imu");
  double product = 0, sum_rate = 0, sum_force = 0;
  constexpr int n = 20'000;
  for (int k = 0; k < n; ++k) {
    auto still = ideal(Vector3d::Zero(), Vector3d::Zero());
    still.origin.valid_at = stamp_from_ns(k * 10'000'000LL);
    const auto a = errors.apply(still);
    ASSERT_EQ(a.angular_rate, again.apply(still).angular_rate);
    ASSERT_NE(a.angular_rate, other.apply(still).angular_rate);
    product += a.angular_rate.x() * a.specific_force.x();
    sum_rate += a.angular_rate.x() * a.angular_rate.x();
    sum_force += a.specific_force.x() * a.specific_force.x();
  }
  EXPECT_LT(std::abs(product / std::sqrt(sum_rate * sum_force)), 4 / std::sqrt(n));
}

TEST(ImuErrors, SaturateLast) {
  const auto config = grade("xsens-mti-630.toml");
  ImuErrors errors(config, 100, 1, "imu");
  const auto reading = errors.apply(ideal({40, 0, 0}, {0, -200, 0}));
  EXPECT_EQ(reading.angular_rate.x(), 2000 * degree);
  EXPECT_EQ(reading.specific_force.y(), -10 * g);
}

}  // namespace imu_errors_test
}  // namespace drydock::sensor
