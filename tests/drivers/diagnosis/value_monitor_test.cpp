#include "drivers/diagnosis/monitors/value_monitor.hpp"

#include <gtest/gtest.h>

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

}  // namespace drydock::diagnosis::value_monitor_test
