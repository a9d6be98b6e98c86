#include "hil/sensor/random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace drydock::sensor {
namespace {

TEST(Random, SplitMixGivesThePublishedSequences) {
  // Reference outputs of Vigna's splitmix64.c for the seeds 0 and 1234567.
  std::uint64_t state = 0;
  EXPECT_EQ(splitmix64(state), 0xE220A8397B1DCDAFu);
  EXPECT_EQ(splitmix64(state), 0x6E789E6AA1B965F4u);
  EXPECT_EQ(splitmix64(state), 0x06C45D188009454Fu);
  state = 1234567;
  for (const std::uint64_t expected :
       {6457827717110365317u, 3203168211198807973u, 9817491932198370423u}) {
    EXPECT_EQ(splitmix64(state), expected);
  }
}

TEST(Random, NormalNumbersHaveTheMomentsOfTheNormalDistribution) {
  RandomStream stream(1, "imu", "noise");
  constexpr int n = 400'000;
  std::array<double, 5> moment{};
  int beyond_two_sigma = 0;
  for (int i = 0; i < n; ++i) {
    const double x = stream.normal();
    for (std::size_t k = 1; k < moment.size(); ++k) moment[k] += std::pow(x, k) / n;
    beyond_two_sigma += std::abs(x) > 2;
  }
  // Four standard errors: sqrt(var(x^k) / n) with var 1, 2, 15, 96.
  const double four = 4 / std::sqrt(n);
  EXPECT_NEAR(moment[1], 0, four);
  EXPECT_NEAR(moment[2], 1, four * std::sqrt(2));
  EXPECT_NEAR(moment[3], 0, four * std::sqrt(15));
  EXPECT_NEAR(moment[4], 3, four * std::sqrt(96));
  EXPECT_NEAR(beyond_two_sigma, 0.04550026 * n, 4 * std::sqrt(0.0455 * 0.9545 * n));
}

TEST(Random, ANormalNumberTimesSigmaIsTheProductToTheLastBitAndDrawsAsMuch) {
  for (const double sigma : {0.0, 1.5}) {
    RandomStream product(3, "dvl", "beams"), whole(3, "dvl", "beams");
    for (int i = 0; i < 100'000; ++i) {
      const double expected = sigma * product.normal(), found = whole.normal(sigma);
      ASSERT_EQ(found, expected);
      ASSERT_EQ(std::signbit(found), std::signbit(expected));
    }
    EXPECT_EQ(whole.next(), product.next());
  }
}

double correlation(RandomStream a, RandomStream b) {
  constexpr int n = 100'000;
  double sum = 0;
  for (int i = 0; i < n; ++i) sum += a.normal() * b.normal();
  return sum / n;
}

TEST(Random, StreamsOfOtherSeedsDevicesAndNamesAreIndependent) {
  const RandomStream stream(1, "imu", "gyro");
  const double four_sigma = 4 / std::sqrt(100'000);
  EXPECT_LT(std::abs(correlation(stream, RandomStream(2, "imu", "gyro"))), four_sigma);
  EXPECT_LT(std::abs(correlation(stream, RandomStream(1, "imu2", "gyro"))), four_sigma);
  EXPECT_LT(std::abs(correlation(stream, RandomStream(1, "imu", "accelerometer"))), four_sigma);
  EXPECT_NEAR(correlation(stream, RandomStream(1, "imu", "gyro")), 1, 0.02);
}

TEST(Random, MovingALetterBetweenDeviceAndStreamNameMakesAnotherStream) {
  RandomStream a(1, "imu1", "gyro"), b(1, "imu", "1gyro");
  EXPECT_NE(a.next(), b.next());
}

}  // namespace
}  // namespace drydock::sensor
