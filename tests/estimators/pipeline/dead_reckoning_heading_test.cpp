#include <gtest/gtest.h>

#include <algorithm>

#include "tests/estimators/pipeline/reckoning_lies.hpp"

/// Compasses that mislead a dead reckoning, or say nothing.
namespace drydock::pipeline::dead_reckoning_heading_test {
namespace {

using namespace reckoning_runs;
using Eigen::Vector2d;

/// A compass leaps by 20 degrees at once. The DVL's compass, 40 degrees beside it, did not.
TEST(DeadReckoningHeading, TheDvlsCompassStandsInForOneThatLeaps) {
  Reckoning run(by_both());
  sail(run, 120, [](double s) { return Lies{.heading = s >= 60 ? 20 * degree : 0}; });
  EXPECT_LT(judged(run.all).wrong_s, 0.1);
  EXPECT_NEAR(run.offset().y(), 0, 3);
}

/// Without another one nobody knows: the heading may be wrong by the leap, and it says so.
TEST(DeadReckoningHeading, ACompassThatMakesAStepMayBeWrongByIt) {
  ReckoningOptions options = by_log();
  options.gnss.reset();
  options.start = start;
  Reckoning run(options);
  const auto stepped = [](double s) {
    return Lies{.fix = {}, .dvl = {}, .heading = within(s, 60, 90) ? 10 * degree : 0};
  };
  sail(run, 80, stepped);
  EXPECT_NEAR(std::sqrt(run.all.back().covariance(8, 8)), 10 * degree, degree);
  EXPECT_FALSE(run.all.back().integrity.valid);  // its bound is 53 degrees, the limit 20
  sail(run, 120, stepped, 80.2);
  EXPECT_NEAR(std::sqrt(run.all.back().covariance(8, 8)), degree, 0.2 * degree);
  EXPECT_TRUE(run.all.back().integrity.valid);
  EXPECT_LT(judged(run.all).wrong_s, 2);
}

/// For 30 s nobody tells the heading, and the vehicle makes an S: at its end the line between the
/// speeds is off by the way that it had to go, at most 2 m/s times 30 s.
TEST(DeadReckoningHeading, AGapOfHeadingsIsAsUncertainAsTheTurnsInIt) {
  ReckoningOptions options = by_dvl();
  options.heading = at_origin(compass_device);
  options.errors.position_m = 0.5;
  Reckoning run(options);
  for (int s = 0; s <= 120; ++s) {
    if (s < 60 || s >= 90) run.take(compass(1000 * s, 0));
    auto speed = track(1000 * s, {speed_mps, 0, 0}, 0);
    speed.heading_rad.reset();
    run.take(speed);
  }
  // Brownian motion of 10 degrees per root second between two known headings: v sqrt(q T^3 / 12).
  const double sigma = speed_mps * 10 * degree * std::sqrt(std::pow(31, 3) / 12);
  EXPECT_NEAR(std::sqrt(run.all.back().covariance(1, 1)), sigma, 3);
}

TEST(DeadReckoningHeading, HeadingsThatComeLateAreWrongByTheTurn) {
  Reckoning run(by_both());
  for (int tick = 0; tick <= 300; ++tick) {
    const double heading = 5 * degree * tick / 5;
    run.take(compass(200 * tick, frame::wrap_pi(heading)));
    run.take(track(200 * tick, {speed_mps, 0, 0}, frame::wrap_pi(heading)));
  }
  EXPECT_NEAR(std::sqrt(run.all.back().covariance(8, 8)), degree, 0.1 * degree);
  run.estimator.doubt(compass_device, true);
  run.take(track(60'200, {speed_mps, 0, 0}, 301 * degree));
  // One second of 5 degrees a second, beside the degree that it always may have.
  EXPECT_NEAR(std::sqrt(run.all.back().covariance(8, 8)), std::sqrt(26) * degree, 0.2 * degree);
}

/// The tilt of compass and DVL were the same, then the compass drifts by 15 degrees.
TEST(DeadReckoningHeading, TiltsOfCompassAndDvlThatContradictAreNotValid) {
  Reckoning run(by_both());
  const auto roll_of = [](int tick) { return tick < 300 ? 0 : 0.15 * degree * (tick - 300); };
  for (int tick = 0; tick <= 400; ++tick) {
    auto tilted = compass(200 * tick, wobble(tick, 1) * 0.1);
    tilted.roll_rad = roll_of(tick) + wobble(tick, 4) * 0.1;
    tilted.pitch_rad = 0;
    run.take(tilted);
    run.take(track(200 * tick, {speed_mps, 0, 0}, 0));
    const auto& last = run.all.back();
    const double roll = frame::euler(last.body_to_ned).roll;
    if (last.integrity.valid) EXPECT_LT(roll, 5 * std::sqrt(last.covariance(6, 6))) << tick;
    if (tick < 300) EXPECT_TRUE(last.integrity.valid) << tick;
  }
  EXPECT_FALSE(run.all.back().integrity.valid);
}

}  // namespace
}  // namespace drydock::pipeline::dead_reckoning_heading_test
