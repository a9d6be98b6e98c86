#include "drivers/diagnosis/monitors/value_monitor.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "tests/drivers/diagnosis/signs.hpp"

namespace drydock::diagnosis::value_monitor_test {

using measurement::BottomVelocity;

/// A DVL at 5 Hz with noise of 1 cm/s, watched for a minute.
struct DvlThatIsWatched : testing::Test {
  DvlThatIsWatched() {
    for (int i = 0; i < 300; ++i) come(noisy());
  }
  Eigen::Vector3d noisy() {
    return {1 + 0.01 * normal(random), 0.01 * normal(random), 0.01 * normal(random)};
  }
  void come(const std::optional<Eigen::Vector3d>& velocity) {
    BottomVelocity sample;
    sample.origin.received_at = at_s(now += 0.2);
    sample.velocity = velocity;
    monitor.take(stream_of(sample), sample);
    monitor.look(at_s(now));
  }
  Signs signs;
  ValueMonitor monitor{{.kind = measurement::Kind::dvl, .nominal_rate_hz = 5}, signs};
  std::mt19937_64 random{4};
  std::normal_distribution<double> normal;
  double now = 0;
};

TEST_F(DvlThatIsWatched, HasNoSignInHours) {
  for (int i = 0; i < 50'000; ++i) come(noisy());
  EXPECT_TRUE(signs.all.empty());
}

TEST_F(DvlThatIsWatched, IsStuckAfterSevenEqualSamples) {
  const Eigen::Vector3d last = noisy();
  for (int i = 0; i < 7; ++i) come(last);
  EXPECT_FALSE(signs.has(Sign::stuck));
  come(last);
  EXPECT_TRUE(signs.has(Sign::stuck));
}

TEST_F(DvlThatIsWatched, ReportsAConstantThatIsNotItsLastValue) {
  for (int i = 0; i < 8; ++i) come(Eigen::Vector3d{0, 0, 0});
  EXPECT_TRUE(signs.has(Sign::out_of_range));
  EXPECT_FALSE(signs.has(Sign::stuck));
}

TEST_F(DvlThatIsWatched, HasLostTheBottomAfterOneSecond) {
  for (int i = 0; i < 4; ++i) come({});
  EXPECT_FALSE(signs.has(Sign::values_missing));
  for (int i = 0; i < 2; ++i) come({});
  EXPECT_TRUE(signs.has(Sign::values_missing));
}

TEST_F(DvlThatIsWatched, HasAWildSample) {
  come(noisy() + Eigen::Vector3d{5, 0, 0});
  come(noisy());
  ASSERT_TRUE(signs.has(Sign::wild_samples));
  EXPECT_NEAR(signs.first(Sign::wild_samples).value, 5, 0.1);
  EXPECT_FALSE(signs.has(Sign::noisy));
}

// Without a checksum single samples of all sizes are damaged bits; with one they are the sensor's.
TEST(ValueMonitor, TellsDamagedBitsFromSpikesByTheirSizes) {
  for (const bool equal : {true, false}) {
    Signs signs;
    ValueMonitor monitor({.kind = measurement::Kind::depth, .nominal_rate_hz = 10}, signs);
    for (int i = 0; i < 600; ++i) {
      measurement::DepthSample sample;
      sample.origin.received_at = at_s(i * 0.1);
      const double spike = i > 500 && i % 20 == 0 ? (equal ? 1e6 : 1e5 * (i - 500)) : 0;
      sample.pressure_pa = 2e5 + i % 3 * 100 + spike;
      monitor.take(stream_of(sample), sample);
    }
    EXPECT_TRUE(signs.has(Sign::wild_samples));
    EXPECT_EQ(signs.has(Sign::wild_unequal), !equal);
  }
}

/// An IMU at 100 Hz as that of the leveling paper: 0.3 deg/h and 50 ug of noise, watched for a
/// minute while it turns.
struct ImuThatIsWatched : testing::Test {
  static constexpr double gyro_noise = 0.3 * std::numbers::pi / 180 / 3600, noise = 50e-6 * 9.81;
  ImuThatIsWatched() {
    for (int i = 0; i < 6000; ++i) come();
  }
  Eigen::Vector3d white() { return {normal(random), normal(random), normal(random)}; }
  void come() {
    measurement::ImuSample sample;
    now += 0.01;
    sample.origin.received_at = at_s(now);
    const Eigen::Vector3d turn{0, 0, 0.1 * std::sin(now / 5)};
    sample.angular_rate = frozen ? *frozen : Eigen::Vector3d{turn + times * gyro_noise * white()};
    sample.specific_force = Eigen::Vector3d{0, 0.2 * turn.z(), -9.81} + noise * white();
    rate = sample.angular_rate;
    monitor.take(stream_of(sample), sample);
  }
  Signs signs;
  ValueMonitor monitor{{.kind = measurement::Kind::imu, .nominal_rate_hz = 100}, signs};
  std::mt19937_64 random{4};
  std::normal_distribution<double> normal;
  std::optional<Eigen::Vector3d> frozen;
  Eigen::Vector3d rate;
  double now = 0, times = 1;
};

TEST_F(ImuThatIsWatched, HasNoSignInAnHour) {
  for (int i = 0; i < 360'000; ++i) come();
  EXPECT_TRUE(signs.all.empty());
}

TEST_F(ImuThatIsWatched, IsStuckWhereOnlyItsGyrosAre) {
  frozen = rate;
  for (int i = 0; i < 100; ++i) come();
  EXPECT_TRUE(signs.has(Sign::stuck));
}

TEST_F(ImuThatIsWatched, IsNoisyAtFiveTimesTheNoiseOfItsQuietGyros) {
  times = 5;
  for (int i = 0; i < 200; ++i) come();
  EXPECT_TRUE(signs.has(Sign::noisy));
}

/// A log at 2 Hz with noise of 0.1 m/s at 1.8 m/s that says 0.8 m/s from now on: ten deviations.
TEST(ValueMonitor, TellsAWrongConstantNearTheTruthFromALastValue) {
  for (const bool last : {false, true}) {
    Signs signs;
    ValueMonitor monitor{{.kind = measurement::Kind::emlog, .nominal_rate_hz = 2}, signs};
    std::mt19937_64 random{4};
    std::normal_distribution<double> normal{1.8, 0.1};
    measurement::WaterSpeed sample;
    for (int i = 0; i < 160; ++i) {
      if (i < 140) sample.longitudinal_mps = normal(random);
      if (i >= 140 && !last) sample.longitudinal_mps = 0.8;
      sample.origin.received_at = at_s(0.5 * i);
      monitor.take(stream_of(sample), sample);
    }
    EXPECT_EQ(signs.has(Sign::out_of_range), !last);
    EXPECT_EQ(signs.has(Sign::stuck), last);
  }
}

/// A pressure sensor at 10 Hz with 100 Pa of noise on a wave of 2 m in 8 s. A step of half a metre
/// of sea water is no motion: 1025 * 9.81 * 0.5 = 5028 Pa.
TEST(ValueMonitor, SeesAStepOfHalfAMetreOfWaterAndNoneInWaves) {
  Signs signs;
  ValueMonitor monitor{{.kind = measurement::Kind::depth, .nominal_rate_hz = 10}, signs};
  std::mt19937_64 random{4};
  std::normal_distribution<double> normal{0, 100};
  for (int i = 0; i < 36'100; ++i) {
    if (i == 36'000) EXPECT_TRUE(signs.all.empty());
    measurement::DepthSample sample;
    sample.pressure_pa = 2e5 + 1e4 * std::sin(0.1 * i * 2 * std::numbers::pi / 8) + normal(random);
    if (i >= 36'000) *sample.pressure_pa += 5028;
    sample.origin.received_at = at_s(0.1 * i);
    monitor.take(stream_of(sample), sample);
    monitor.look(at_s(0.1 * i));
  }
  EXPECT_TRUE(signs.has(Sign::step));
}

}  // namespace drydock::diagnosis::value_monitor_test
