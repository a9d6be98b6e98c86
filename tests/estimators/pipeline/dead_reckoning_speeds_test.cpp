#include <gtest/gtest.h>

#include <algorithm>

#include "tests/estimators/pipeline/reckoning_lies.hpp"

/// Logs and DVLs that mislead a dead reckoning.
namespace drydock::pipeline::dead_reckoning_speeds_test {
namespace {

using namespace reckoning_runs;
using Eigen::Vector2d;

TEST(DeadReckoningSpeeds, ALogThatLeapsIsNotUsed) {
  Reckoning run(by_log());
  sail(run, 120, [](double s) { return Lies{.log = s == 80 || s == 88 ? 10 : 0}; });
  EXPECT_LT(judged(run.all).wrong_s, 0.1);
  EXPECT_EQ(judged(run.all).invalid, 0);
  EXPECT_EQ(run.estimator.status().wild, 2u);
}

/// Half a metre a second too much, which no fix explains.
TEST(DeadReckoningSpeeds, ALogThatTurnsWrongContradictsTheFixes) {
  for (const double most : {0.25, 0.5, 1.5}) {
    Reckoning run(by_log());
    sail(run, 200, [&](double s) {
      return Lies{.log = within(s, 80, 110) ? most * std::min(1.0, (s - 80) / 20) : 0};
    });
    EXPECT_LT(judged(run.all).wrong_s, 2) << most;
    EXPECT_TRUE(run.all.back().integrity.valid) << most;
  }
}

/// The DVL is wrong by 1 m/s. Log and DVL contradict, and nobody knows which is wrong.
TEST(DeadReckoningSpeeds, ADvlThatTurnsWrongContradictsTheLog) {
  for (const double off : {0.5, 1.0, 3.0}) {
    Reckoning run(by_both());
    sail(run, 200, [&](double s) { return Lies{.dvl = within(s, 80, 110) ? off : 0}; });
    EXPECT_LT(judged(run.all).wrong_s, 2) << off;
    EXPECT_GE(judged(run.all).invalid, 20) << off;
    EXPECT_TRUE(run.all.back().integrity.valid) << off;
    EXPECT_NEAR(run.all.back().current->north_east_mps.x(), 0, 0.05) << off;
  }
}

/// The DVL is wrong by less than the gate for 3 s, then a finding leaves it out for half a minute.
/// What was taken for a current meanwhile may have been its error.
TEST(DeadReckoningSpeeds, ALogGoesOnInDoubtBehindADvlThatWasWrong) {
  for (const double off : {0.2, 0.3, 0.4}) {
    Reckoning run(by_both());
    sail(run, 160, [&](double s) {
      Lies lies{.dvl = within(s, 80, 83) ? off : 0};
      if (within(s, 83, 113)) lies.dvl.reset();
      return lies;
    });
    EXPECT_LT(judged(run.all).wrong_s, 2) << off;
  }
}

TEST(DeadReckoningSpeeds, ADvlThatLeapsIsNotUsed) {
  Reckoning run(by_both());
  sail(run, 120,
       [](double s) { return Lies{.dvl = within(s, 80, 100) && std::fmod(s, 2) < 0.1 ? 5 : 0}; });
  EXPECT_LT(judged(run.all).wrong_s, 0.1);
  EXPECT_EQ(judged(run.all).invalid, 0);
  EXPECT_EQ(run.estimator.status().wild, 10u);
  EXPECT_NEAR(run.offset().x(), 240, 0.5);
}

/// A current that changes by 0.2 m/s in a minute is no contradiction.
TEST(DeadReckoningSpeeds, ACurrentThatChangesSlowlyIsLearnedAnew) {
  Reckoning run(by_both());
  sail(run, 240, [](double s) { return Lies{.log = 0.2 * std::clamp((s - 80) / 60, 0.0, 1.0)}; });
  EXPECT_EQ(judged(run.all).invalid, 0);
  EXPECT_NEAR(run.all.back().current->north_east_mps.x(), -0.2, 0.03);
}

/// A DVL loses the bed for 20 s in a turn of 90 degrees; its compass goes on. The way is a quarter
/// of a circle: 2 m/s times 20 s of arc, so 25.46 m north and as much east.
TEST(DeadReckoningSpeeds, AGapOfSpeedsFollowsTheHeadings) {
  Reckoning run(by_dvl());
  for (int s = 0; s <= 30; ++s) {
    const double heading = 90 * degree * std::clamp((s - 5) / 20.0, 0.0, 1.0);
    auto speed = track(1000 * s, {speed_mps, 0, 0}, heading);
    if (s > 5 && s < 25) speed.velocity.reset();
    run.take(speed);
  }
  const double arm_m = 40 / (std::numbers::pi / 2);
  EXPECT_NEAR(run.offset().x(), 10 + arm_m, 0.05);
  EXPECT_NEAR(run.offset().y(), 10 + arm_m, 0.05);
}

}  // namespace
}  // namespace drydock::pipeline::dead_reckoning_speeds_test
