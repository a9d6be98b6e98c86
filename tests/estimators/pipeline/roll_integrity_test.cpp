// What the roll estimator says of itself while its gyro or its satellites are wrong.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

#include "estimators/frame/attitude.hpp"
#include "estimators/frame/geodetic.hpp"
#include "tests/estimators/pipeline/rocket.hpp"

namespace drydock::pipeline::roll_integrity_test {
namespace {

using roll::test::degree;
using test::Rocket;

constexpr int fault_from_ms = 20'000, fault_until_ms = 30'000, end_ms = 90'000;

bool in_fault(int ms) { return ms >= fault_from_ms && ms < fault_until_ms; }

/// The roll gyro of a sample at a time, as the fault has it.
using Gyro = std::function<double(int ms, double rate)>;

struct Flown {
  test::Estimates estimates;
  EstimatorStatus status;

  /// The longest time in a row in which an estimate was valid and more than 5 sigma wrong.
  double wrong_while_valid_s(const Rocket& rocket) const {
    double longest = 0, now = 0;
    for (const auto& estimate : estimates.all) {
      const bool wrong = estimate.integrity.valid &&
                         error_rad(estimate, rocket) > 5 * std::sqrt(estimate.covariance(0, 0));
      now = wrong ? now + 0.01 : 0;
      longest = std::max(longest, now);
    }
    return longest;
  }
  static double error_rad(const AttitudeEstimate& estimate, const Rocket& rocket) {
    const auto ms =
        std::chrono::duration_cast<std::chrono::milliseconds>(estimate.valid_at - test::at_ms(0));
    return std::abs(frame::wrap_pi(estimate.roll_rad - rocket.roll_deg(ms.count()) * degree));
  }
  double largest_error_deg(const Rocket& rocket, int from_ms) const {
    double largest = 0;
    for (const auto& estimate : estimates.all)
      if (estimate.valid_at >= test::at_ms(from_ms))
        largest = std::max(largest, error_rad(estimate, rocket) / degree);
    return largest;
  }
  double nees_while_valid(const Rocket& rocket, int from_ms) const {
    double sum = 0, valid = 0;
    for (const auto& estimate : estimates.all) {
      if (!estimate.integrity.valid || estimate.valid_at < test::at_ms(from_ms)) continue;
      ++valid;
      sum += std::pow(error_rad(estimate, rocket), 2) / estimate.covariance(0, 0);
    }
    return sum / valid;
  }
  double valid_share(int from_ms) const {
    double valid = 0, all = 0;
    for (const auto& estimate : estimates.all) {
      if (estimate.valid_at < test::at_ms(from_ms)) continue;
      ++all;
      valid += estimate.integrity.valid ? 1 : 0;
    }
    return valid / all;
  }
};

/// A gyro with .1 deg/s of noise a sample, satellites ten times a second.
Flown flown(Rocket& rocket, const Gyro& gyro) {
  Flown flown;
  auto pipeline = *make_pipeline(test::rolling(), flown.estimates);
  std::mt19937_64 random(3);
  std::normal_distribution<double> noise(0, 0.1 * degree);
  for (int t = 0; t <= end_ms; t += 10) {
    auto sample = rocket.imu(t);
    const double rate = sample.angular_rate.x() + noise(random);
    sample.angular_rate.x() = in_fault(t) ? gyro(t, rate) : rate;
    pipeline.receive(sample);
    if (t % 100 != 0) continue;
    pipeline.receive(rocket.fix(t));
    pipeline.receive(rocket.sky(t));
  }
  flown.status = pipeline.status(0);
  return flown;
}

TEST(RollIntegrity, ASoundFlightIsValidFromItsStartToItsEnd) {
  Rocket rocket;
  const auto sound = flown(rocket, [](int, double rate) { return rate; });
  EXPECT_GT(sound.valid_share(3'000), 0.999);
  EXPECT_EQ(sound.status.wild, 0u);
  EXPECT_EQ(sound.status.divergences, 0u);
}

TEST(RollIntegrity, SpikesOfTheGyroAreBridged) {
  Rocket rocket;
  const auto spiky = flown(
      rocket, [](int ms, double rate) { return ms % 100 == 50 ? rate + 100 * degree : rate; });
  EXPECT_EQ(spiky.status.wild, 100u);
  EXPECT_LT(spiky.largest_error_deg(rocket, fault_from_ms), 1.5);
  EXPECT_GT(spiky.valid_share(fault_from_ms), 0.999);
}

TEST(RollIntegrity, AGyroThatIsWrongMakesTheRollInvalidUntilItIsRightAgain) {
  for (const double wrong_degps : {1.0, 5.0, -20.0}) {
    Rocket rocket;
    const auto biased =
        flown(rocket, [&](int, double rate) { return rate + wrong_degps * degree; });
    EXPECT_LT(biased.wrong_while_valid_s(rocket), 2) << wrong_degps;
    EXPECT_LT(biased.largest_error_deg(rocket, fault_until_ms + 20'000), 2) << wrong_degps;
    EXPECT_GT(biased.valid_share(fault_until_ms + 20'000), 0.99) << wrong_degps;
  }
}

TEST(RollIntegrity, AGyroThatLeapsHasANewBiasThatTheSignalsFindWhileTheRollIsValid) {
  for (const double leap_degps : {1.0, -2.0, 3.0}) {
    Rocket rocket;
    const auto leapt = flown(rocket, [&](int, double rate) { return rate + leap_degps * degree; });
    EXPECT_EQ(leapt.wrong_while_valid_s(rocket), 0) << leap_degps;
    EXPECT_LT(leapt.nees_while_valid(rocket, fault_from_ms), 3) << leap_degps;
    EXPECT_GT(leapt.valid_share(fault_from_ms), 0.7) << leap_degps;
  }
}

TEST(RollIntegrity, AGyroThatStandsStillLosesTheRollAndFindsItAgain) {
  Rocket rocket;
  const auto still = flown(rocket, [](int, double) { return 0.0; });
  EXPECT_LT(still.wrong_while_valid_s(rocket), 2);
  EXPECT_LT(still.largest_error_deg(rocket, fault_until_ms + 30'000), 2);
  EXPECT_GT(still.valid_share(fault_until_ms + 30'000), 0.99);
}

TEST(RollIntegrity, AReceiverThatIsLateByAConstantTimeMakesTheRollInvalid) {
  // At 90 deg/s .25 s are 22 degrees, and no signal tells: all of them are of the earlier roll.
  Rocket rocket;
  Flown late;
  auto pipeline = *make_pipeline(test::rolling(), late.estimates);
  const auto start = frame::Position{0.6, 2.2, 1000};
  for (int t = 0; t <= 60'000; t += 10) {
    pipeline.receive(rocket.imu(t));
    if (t % 100 != 0) continue;
    const int then = t < fault_from_ms ? t : t - 250;
    auto fix = rocket.fix(t);
    const auto place = frame::at_ned_offset(start, 0.001 * then * *fix.velocity_ned);
    fix.position = {place.latitude_rad, place.longitude_rad};
    fix.ellipsoidal_height_m = place.height_m;
    pipeline.receive(fix);
    auto sky = rocket.sky(then);
    sky.origin.valid_at = test::at_ms(t);
    pipeline.receive(sky);
  }
  EXPECT_GT(late.largest_error_deg(rocket, fault_from_ms + 10'000), 15);
  EXPECT_LT(late.wrong_while_valid_s(rocket), 0.2);
}

TEST(RollIntegrity, ADoubtedDeviceMakesTheEstimatesInvalidUntilItIsSound) {
  for (const std::uint16_t device : {test::imu_device, test::gnss_device}) {
    test::Estimates estimates;
    auto pipeline = *make_pipeline(test::rolling(), estimates);
    Rocket rocket;
    const auto fly = [&](int from_ms, int to_ms) {
      for (int t = from_ms; t < to_ms; t += 10) {
        pipeline.receive(rocket.imu(t));
        if (t % 100 != 0) continue;
        pipeline.receive(rocket.fix(t));
        pipeline.receive(rocket.sky(t));
      }
      return estimates.all.back().integrity.valid;
    };
    EXPECT_TRUE(fly(0, 10'000));
    pipeline.doubt(device, true);
    EXPECT_FALSE(fly(10'000, 20'000));
    pipeline.doubt(device, false);
    EXPECT_FALSE(fly(20'000, 24'900));
    EXPECT_TRUE(fly(24'900, 25'100));
  }
}

}  // namespace
}  // namespace drydock::pipeline::roll_integrity_test
