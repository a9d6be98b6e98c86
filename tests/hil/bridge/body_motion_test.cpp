#include "hil/bridge/body_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace drydock::bridge {
namespace body_motion_test {

using Eigen::Vector3d;
using std::chrono::milliseconds;

Stamp at_ms(int ms) { return Stamp{milliseconds{ms}}; }

measurement::ImuSample turning(int ms, const Vector3d& rate_radps) {
  measurement::ImuSample sample;
  sample.origin.valid_at = at_ms(ms);
  sample.angular_rate = rate_radps;
  return sample;
}

/// 100 Hz from 0 to `until_ms`.
RotationHistory turning_until(int until_ms, const Vector3d& rate_radps) {
  RotationHistory history;
  for (int ms = 0; ms <= until_ms; ms += 10) history.add(turning(ms, rate_radps));
  return history;
}

TEST(RotationHistory, GivesTheAngleOfASteadyTurnAtAnyTwoTimes) {
  const auto history = turning_until(1000, {0, 0, 0.5});
  const auto turn = history.between(at_ms(123), at_ms(868));
  ASSERT_TRUE(turn);
  const Eigen::AngleAxisd seen(*turn);
  EXPECT_NEAR(seen.angle() * seen.axis().z(), 0.5 * 0.745, 1e-12);
}

TEST(RotationHistory, GoesOnWithTheLastRateForAShortTime) {
  const auto history = turning_until(500, {0.2, 0, 0});
  const auto turn = history.between(at_ms(500), at_ms(600));
  ASSERT_TRUE(turn);
  EXPECT_NEAR(2 * turn->x(), 0.02, 1e-6);
  EXPECT_FALSE(history.between(at_ms(500), at_ms(800)));
}

TEST(RotationHistory, KnowsNothingOfTimesBeforeItsSamplesOrAcrossAGap) {
  auto history = turning_until(500, {0, 0, 1});
  EXPECT_FALSE(history.between(at_ms(-10), at_ms(100)));
  history.add(turning(900, {0, 0, 1}));
  EXPECT_FALSE(history.between(at_ms(400), at_ms(900)));
  EXPECT_FALSE(RotationHistory{}.between(at_ms(0), at_ms(1)));
}

TEST(BodyMotion, OfASteadySpeedIsSpeedTimesTime) {
  BodyMotion motion;
  const auto still = turning_until(1000, Vector3d::Zero());
  EXPECT_FALSE(motion.add(at_ms(100), {1, -0.5, 0.25}, still)) << "nothing is before it";
  const auto moved = motion.add(at_ms(350), {1, -0.5, 0.25}, still);
  ASSERT_TRUE(moved);
  EXPECT_EQ(moved->time, milliseconds{250});
  EXPECT_TRUE(moved->position_m.isApprox(Vector3d(0.25, -0.125, 0.0625), 1e-12));
  EXPECT_TRUE(moved->angle_rad.isZero(1e-12));
  EXPECT_TRUE(moved->rotation_known);
}

// A body that goes ahead with v and turns with w is, in the axes that it then has, at v/w (sin wt,
// -(1 - cos wt)) from where it was. The trapezoidal rule is wrong by (w dt)^2 / 12 of the way.
TEST(BodyMotion, OnACircleIsTheChordInTheAxesAtItsEnd) {
  constexpr double v = 1.5, w = 0.4, dt = 0.1;
  BodyMotion motion;
  const auto history = turning_until(1500, {0, 0, w});
  std::optional<Moved> moved;
  for (int ms = 0; ms <= 1000; ms += 100) moved = motion.add(at_ms(ms), {v, 0, 0}, history);
  ASSERT_TRUE(moved);
  const double bound = v * 1.0 * (w * dt) * (w * dt) / 12;
  EXPECT_NEAR(moved->angle_rad.z(), w, 1e-9);
  EXPECT_NEAR(moved->position_m.x(), v / w * std::sin(w), bound);
  EXPECT_NEAR(moved->position_m.y(), -v / w * (1 - std::cos(w)), bound);
}

TEST(BodyMotion, OfASpeedThatGrowsEvenlyIsExact) {
  BodyMotion motion;
  const auto still = turning_until(1000, Vector3d::Zero());
  motion.add(at_ms(0), {0, 0, 0}, still);
  motion.add(at_ms(400), {0.8, 0, 0}, still);
  const auto moved = motion.add(at_ms(1000), {2, 0, 0}, still);
  ASSERT_TRUE(moved);
  EXPECT_NEAR(moved->position_m.x(), 0.5 * 2 * 1 * 1, 1e-12);  // a t^2 / 2 with a = 2 m/s2
}

TEST(BodyMotion, CountsFromTheMark) {
  BodyMotion motion;
  const auto still = turning_until(1000, Vector3d::Zero());
  motion.add(at_ms(0), {1, 0, 0}, still);
  motion.add(at_ms(100), {1, 0, 0}, still);
  motion.mark();
  const auto moved = motion.add(at_ms(300), {1, 0, 0}, still);
  ASSERT_TRUE(moved);
  EXPECT_EQ(moved->time, milliseconds{200});
  EXPECT_NEAR(moved->position_m.x(), 0.2, 1e-12);
}

TEST(BodyMotion, WithoutAnImuCountsAsStraightAndSaysSo) {
  BodyMotion motion;
  motion.add(at_ms(0), {1, 0, 0}, {});
  const auto moved = motion.add(at_ms(100), {1, 0, 0}, {});
  ASSERT_TRUE(moved);
  EXPECT_NEAR(moved->position_m.x(), 0.1, 1e-12);
  EXPECT_FALSE(moved->rotation_known);
}

TEST(BodyMotion, BeginsAnewAfterAPauseAndWhenToldTo) {
  BodyMotion motion;
  const auto still = turning_until(4000, Vector3d::Zero());
  motion.add(at_ms(0), {1, 0, 0}, still);
  EXPECT_FALSE(motion.add(at_ms(1001), {1, 0, 0}, still)) << "more than a second without a ping";
  EXPECT_TRUE(motion.add(at_ms(2001), {1, 0, 0}, still));
  motion.forget();
  EXPECT_FALSE(motion.add(at_ms(2100), {1, 0, 0}, still));
  EXPECT_FALSE(motion.add(at_ms(2100), {1, 0, 0}, still)) << "the same ping twice";
}

}  // namespace body_motion_test
}  // namespace drydock::bridge
