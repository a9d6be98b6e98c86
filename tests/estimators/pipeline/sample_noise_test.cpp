#include "estimators/pipeline/sample_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/estimators/pipeline/support.hpp"

namespace drydock::pipeline::sample_noise_test {
namespace {

constexpr double sigma = 2e-3;

/// An IMU of 100 Hz on a vehicle that sways by 10 degrees in 6 s.
measurement::ImuSample swaying(int i) {
  auto sample = test::imu(10L * i);
  const double w = 1.047, t = 0.01 * i;
  sample.angular_rate = {0.1745 * w * std::cos(w * t), 0, 0.05};
  return sample;
}

TEST(SampleNoise, IsThatOfTheSamplesHoweverTheVehicleMoves) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> noise(0, sigma);
  SampleNoise learned;
  double mean = 0;
  constexpr int n = 20'000;
  for (int i = 0; i < n; ++i) {
    auto sample = swaying(i);
    sample.angular_rate.x() += noise(random);
    learned.add(sample);
    if (i >= 1000) mean += learned.rate_variance() / (n - 1000);
  }
  EXPECT_NEAR(mean, sigma * sigma, 0.05 * sigma * sigma);
}

TEST(SampleNoise, OfASmoothMotionIsNoneAlsoWhereSamplesAreMissing) {
  // The second difference of the motion is .18 rad/s (w T)^2 at most, 2e-5 rad/s.
  SampleNoise learned;
  for (int i = 0; i < 2000; ++i) {
    if (i % 5 != 3) learned.add(swaying(i));
    EXPECT_LT(learned.rate_variance(), 2.1e-5 * 2.1e-5 / 6);
  }
}

TEST(SampleNoise, OneSampleThatIsOffCountsItsSquareInTheWhole) {
  // Second differences of A, -2 A and A have the squares 6 A^2. A mean spreads them over its time.
  constexpr double off = 0.01;
  SampleNoise learned;
  double sum = 0;
  for (int i = 0; i < 3000; ++i) {
    auto sample = test::imu(10L * i);
    if (i == 100) sample.angular_rate.y() += off;
    learned.add(sample);
    sum += learned.rate_variance();
  }
  EXPECT_NEAR(sum, off * off, 1e-6 * off);
}

TEST(SampleNoise, CountsBeyondTheSheetFromTwiceOfIt) {
  EXPECT_EQ(beyond_sheet(3.9, 1), 0);
  EXPECT_EQ(beyond_sheet(4.1, 1), 4.1 - 1);
  EXPECT_EQ(beyond_sheet(std::nan(""), 1), 0);
}

}  // namespace
}  // namespace drydock::pipeline::sample_noise_test
