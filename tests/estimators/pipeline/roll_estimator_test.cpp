#include "estimators/pipeline/roll_estimator.hpp"

#include <gmock/gmock.h>

#include <limits>

#include "estimators/frame/attitude.hpp"
#include "tests/estimators/pipeline/rocket.hpp"

namespace drydock::pipeline::roll_estimator_test {
namespace {

using roll::test::degree;
using std::chrono::milliseconds;
using test::at_ms;
using test::boresight_dbhz;
using test::gnss_device;
using test::Rocket;
using test::rolling;

/// Feeds all samples until `end_ms`. Epochs arrive `late_ms` after their time.
void fly(Pipeline& pipeline, Rocket& rocket, int end_ms, int late_ms = 0) {
  for (int t = 0; t <= end_ms; t += 10) {
    pipeline.receive(rocket.imu(t));
    const int epoch = t - late_ms;
    if (epoch < 0 || epoch % 100 != 0) continue;
    pipeline.receive(rocket.fix(epoch));
    pipeline.receive(rocket.sky(epoch));
  }
}

double last_error_deg(const test::Estimates& estimates, const Rocket& rocket) {
  const auto& last = estimates.all.back();
  const auto ms = std::chrono::duration_cast<milliseconds>(last.valid_at - at_ms(0)).count();
  return frame::wrap_pi(last.roll_rad - rocket.roll_deg(ms) * degree) / degree;
}

TEST(RollEstimator, GivesRollWithItsErrorAndWhoFedIt) {
  test::Estimates estimates;
  auto pipeline = *make_pipeline(rolling(), estimates);
  Rocket rocket;
  fly(pipeline, rocket, 20000);
  ASSERT_FALSE(estimates.all.empty());
  const auto& last = estimates.all.back();
  EXPECT_EQ(last.valid_at, at_ms(20000));
  EXPECT_LT(std::abs(last_error_deg(estimates, rocket)), 1);
  EXPECT_NEAR(last.pitch_rad, rocket.flight.pitch, 1e-9);
  EXPECT_NEAR(last.yaw_rad.value(), rocket.flight.azimuth, 1e-9);
  EXPECT_EQ(last.fed_by, 1u << test::imu_device | 1u << gnss_device);
  EXPECT_GT(last.covariance(0, 0), 0);
  EXPECT_LT(std::sqrt(last.covariance(0, 0)) / degree, 3);
  EXPECT_EQ(pipeline.status(0).state, EstimatorState::running);
}

TEST(RollEstimator, ASignalOutsideTheGateIsCountedAndWithoutEffect) {
  test::Estimates spoilt, clean;
  for (auto* estimates : {&spoilt, &clean}) {
    auto pipeline = *make_pipeline(rolling(), *estimates);
    Rocket rocket;
    fly(pipeline, rocket, 20000);
    const auto before = pipeline.status(0).rejected;
    auto sky = rocket.sky(20000);
    sky.satellites.resize(1);
    if (estimates == &spoilt) sky.satellites[0].cno_dbhz = boresight_dbhz + 7;  // five times
    if (estimates == &clean) sky.satellites[0].cno_dbhz.reset();
    pipeline.receive(sky);
    pipeline.receive(rocket.imu(20010));
    EXPECT_EQ(pipeline.status(0).rejected, before + (estimates == &spoilt ? 1 : 0));
  }
  EXPECT_EQ(spoilt.all.back().roll_rad, clean.all.back().roll_rad);
}

TEST(RollEstimator, EpochsThatComeLateCountForTheirOwnTime) {
  for (const int late_ms : {50, 130, 400}) {
    test::Estimates estimates;
    auto pipeline = *make_pipeline(rolling(), estimates);
    Rocket rocket;
    rocket.flight.rate_radps = 731 * degree;  // 73 deg in 0.1 s
    fly(pipeline, rocket, 20000, late_ms);
    EXPECT_LT(std::abs(last_error_deg(estimates, rocket)), 2) << late_ms;
    EXPECT_GT(pipeline.counters()[gnss_device].delayed, 150u);
  }
}

TEST(RollEstimator, AnyOrderWithinTheWindowGivesTheSameToTheLastBit) {
  const auto run = [](int late_ms) {
    test::Estimates estimates;
    auto pipeline = *make_pipeline(rolling(milliseconds{200}), estimates);
    Rocket rocket;
    fly(pipeline, rocket, 5000, late_ms);
    estimates.all.resize(400);
    return estimates.all.back().roll_rad;
  };
  EXPECT_EQ(run(0), run(150));
}

TEST(RollEstimator, WithoutVerticalVelocityHeightsGiveThePitch) {
  test::Estimates estimates;
  auto pipeline = *make_pipeline(rolling(), estimates);
  Rocket rocket;
  for (int t = 0; t <= 5000; t += 10) {
    pipeline.receive(rocket.imu(t));
    if (t % 100 != 0) continue;
    auto fix = rocket.fix(t);
    fix.ground_speed_mps = fix.velocity_ned->head<2>().norm();
    fix.course_rad = rocket.flight.azimuth;
    fix.mean_sea_level_height_m = 1000 - fix.velocity_ned->z() * 0.001 * t;
    fix.velocity_ned.reset();
    pipeline.receive(fix);
    pipeline.receive(rocket.sky(t));
  }
  ASSERT_FALSE(estimates.all.empty());
  EXPECT_NEAR(estimates.all.back().pitch_rad / degree, rocket.flight.pitch / degree, 0.01);
}

TEST(RollEstimator, WithoutSpeedOrSatellitesThereIsNoEstimate) {
  test::Estimates estimates;
  auto pipeline = *make_pipeline(rolling(), estimates);
  Rocket slow;
  slow.speed_mps = 5;
  fly(pipeline, slow, 2000);
  EXPECT_TRUE(estimates.all.empty());
  EXPECT_EQ(pipeline.status(0).state, EstimatorState::waiting_for_satellites);
  EXPECT_EQ(pipeline.counters()[gnss_device].accepted, 0u);
}

TEST(RollEstimator, NumbersThatAreNoneAreRefused) {
  test::Estimates estimates;
  auto pipeline = *make_pipeline(rolling(), estimates);
  Rocket rocket;
  auto imu = rocket.imu(0);
  imu.angular_rate.x() = std::numeric_limits<double>::quiet_NaN();
  pipeline.receive(imu);
  auto fix = rocket.fix(0);
  fix.velocity_ned->x() = std::numeric_limits<double>::infinity();
  pipeline.receive(fix);
  EXPECT_EQ(pipeline.counters()[test::imu_device].refused, 1u);
  EXPECT_EQ(pipeline.counters()[gnss_device].refused, 1u);
}

TEST(RollEstimator, ASilentImuStartsItAsFromNew) {
  test::Estimates estimates;
  auto pipeline = *make_pipeline(rolling(), estimates);
  Rocket rocket;
  fly(pipeline, rocket, 3000);
  pipeline.receive(rocket.imu(4000));
  EXPECT_EQ(pipeline.status(0).restarts, 1u);
  EXPECT_EQ(pipeline.status(0).state, EstimatorState::waiting_for_satellites);
}

TEST(RollEstimator, NeedsAReceiver) {
  test::Estimates estimates;
  auto options = rolling();
  std::get<RollOptions>(options.estimators[0].kind).gnss.reset();
  const auto made = make_pipeline(options, estimates);
  ASSERT_FALSE(made);
  EXPECT_THAT(made.error().message, testing::HasSubstr("gnss = a device"));
}

}  // namespace
}  // namespace drydock::pipeline::roll_estimator_test
