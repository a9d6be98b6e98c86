#include <gtest/gtest.h>

#include "tests/estimators/pipeline/reckoning_runs.hpp"

/// Dead reckoning with a log, alone and beside a DVL.
namespace drydock::pipeline::dead_reckoning_log_test {
namespace {

using namespace reckoning_runs;
using Eigen::Vector2d;

/// 0.3 m/s of current to the east shows while DVL and log both speak. Then the bed is out of reach.
TEST(DeadReckoning, WithoutBottomLockTheLogGoesOnWithTheCurrentThatWasSeen) {
  ReckoningOptions options = by_dvl();
  options.log = at_origin(log_device);
  options.heading = at_origin(compass_device);
  Reckoning run(options);
  for (int s = 0; s <= 300; ++s) {
    run.take(compass(1000 * s, 0));
    if (s <= 60) run.take(track(1000 * s, {2, 0.3, 0}, 0));
    run.take(log_speed(1000 * s, 2));
  }
  EXPECT_NEAR(run.offset().x(), 600, 1);
  EXPECT_NEAR(run.offset().y(), 90, 1);
  ASSERT_TRUE(run.all.back().current);
  EXPECT_NEAR(run.all.back().current->north_east_mps.y(), 0.3, 0.01);
  EXPECT_EQ(run.estimator.status().bridged, 1u);  // until the log takes over
}

/// The current is not known: after 1000 s it has 0.2 m/s times 1000 s of error.
TEST(DeadReckoning, ALogAloneHasTheErrorOfTheCurrent) {
  ReckoningOptions options = by_dvl();
  options.dvl.reset();
  options.log = at_origin(log_device);
  options.heading = at_origin(compass_device);
  Reckoning run(options);
  for (int s = 0; s <= 1000; ++s) {
    run.take(compass(1000 * s, 0));
    run.take(log_speed(1000 * s, 2));
  }
  EXPECT_NEAR(run.offset().x(), 2000, 1e-2);
  EXPECT_NEAR(std::sqrt(run.all.back().covariance(0, 0)), 200, 1);
}

ReckoningOptions by_both() {
  ReckoningOptions options = by_dvl();
  options.log = at_origin(log_device);
  options.heading = at_origin(compass_device);
  return options;
}

/// All sensors are right, and the vehicle turns in a current of 0.3 m/s. The difference of DVL and
/// log turns with the vehicle, so it says nothing of the heading: neither an error nor a bound.
TEST(DeadReckoningWithALog, TheDifferenceOfBothSpeedsLeavesARightHeadingAlone) {
  ReckoningOptions options = by_both();
  options.errors.heading_rad = 10 * degree;
  options.errors.scale = 0.05;
  Reckoning run(options);
  const Vector2d current{0.1, 0.28};
  for (int ms = 0; ms <= 600'000; ms += 200) {
    const double heading = 2 * degree * ms / 1000;
    const Vector2d across = Eigen::Rotation2Dd(-heading) * current;
    run.take(compass(ms, frame::wrap_pi(heading)));
    run.take(track(ms, {2 + across.x(), across.y(), 0}, 0));
    measurement::WaterSpeed water = log_speed(ms, 2);
    water.transverse_mps = 0;
    run.take(water);
    const auto& last = run.all.back();
    ASSERT_NEAR(frame::wrap_pi(frame::euler(last.body_to_ned).yaw - heading), 0, 1e-9);
    ASSERT_NEAR(std::sqrt(last.covariance(8, 8)), 10 * degree, 1e-9);
  }
  EXPECT_NEAR(run.all.back().current->north_east_mps.x(), 0.1, 1e-3);
  EXPECT_NEAR(run.all.back().current->north_east_mps.y(), 0.28, 1e-3);
  // A heading that may be 10 degrees wrong turns a current of 0.297 m/s by as much.
  EXPECT_NEAR(run.all.back().current->sigma_mps.x(), 0.28 * 10 * degree, 0.003);
}

/// The log is 4 m in front of the DVL and the vehicle turns on the spot of the DVL.
TEST(DeadReckoningWithALog, TheTurnOfTheVehicleIsNoCurrent) {
  ReckoningOptions options = by_both();
  options.log = at(log_device, {4, 0, 0});
  Reckoning run(options);
  const double rate = 3 * degree;
  for (int ms = 0; ms <= 120'000; ms += 200) {
    run.take(compass(ms, frame::wrap_pi(rate * ms / 1000)));
    run.take(track(ms, {1, 0, 0}, 0));
    measurement::WaterSpeed water = log_speed(ms, 1);
    water.transverse_mps = 4 * rate;
    run.take(water);
  }
  EXPECT_LT(run.all.back().current->north_east_mps.norm(), 2e-3);
}

TEST(DeadReckoning, WithoutAGivenStartItBeginsAtTheFirstFix) {
  ReckoningOptions options = by_dvl();
  options.start.reset();
  options.gnss = at(gnss_device, {0, 0, -1});
  Reckoning run(options);
  EXPECT_EQ(run.take(track(0, {1, 0, 0}, 0)), Outcome::unused);
  run.take(fix(500, {30, 40, 0}));
  run.take(track(1000, {1, 0, 0}, 0));
  EXPECT_NEAR(run.offset().x(), 30.5, 1e-4);  // half a second at 1 m/s behind the fix
  EXPECT_NEAR(run.offset().y(), 40, 1e-4);
  EXPECT_NEAR(run.all.back().covariance(0, 0), 4, 1e-3);  // of that fix
}

/// The last fix before the first speed counts, with the way since then. Both were taken at once
/// before: 3 m/s times the time between them.
TEST(DeadReckoning, AFixIsOfItsOwnTime) {
  ReckoningOptions options = by_dvl();
  options.start.reset();
  options.gnss = at_origin(gnss_device);
  Reckoning run(options);
  run.take(fix(0, {0, 0, 0}, 0.01));
  run.take(fix(1000, {3, 0, 0}, 0.01));
  run.take(track(1600, {3, 0, 0}, 0));
  EXPECT_NEAR(run.offset().x(), 4.8, 1e-3);
  // One speed tells of 0.6 s: its noise of 0.02 m/s, and a wander of 0.1 m/s per root second.
  EXPECT_NEAR(run.all.back().covariance(1, 1),
              1e-4 + std::pow(0.02 * 0.6, 2) + 0.01 * 0.216 / 3 + std::pow(1.8 * 0.0175, 2), 1e-6);
}

TEST(DeadReckoning, AGivenStartIsOfTheFirstMeasurement) {
  ReckoningOptions options = by_both();
  Reckoning run(options);
  run.take(compass(0, 0));
  run.take(track(400, {3, 0, 0}, 0));
  EXPECT_NEAR(run.offset().x(), 1.2, 1e-4);
}

/// The antenna is 1 m ahead of the origin and the vehicle heads east, which it does not know at the
/// first fix.
TEST(DeadReckoning, TheAntennasArmTurnsWithTheFirstHeading) {
  ReckoningOptions options = by_both();
  options.start.reset();
  options.gnss = at(gnss_device, {1, 0, 0});
  Reckoning run(options);
  run.take(fix(0, {0, 1, 0}, 0.01));
  run.take(compass(100, 90 * degree));
  run.take(track(200, {0, 0, 0}, 0));
  EXPECT_LT(run.offset().head<2>().norm(), 1e-3);
}

}  // namespace
}  // namespace drydock::pipeline::dead_reckoning_log_test
