#include <gtest/gtest.h>

#include <algorithm>

#include "tests/estimators/pipeline/reckoning_lies.hpp"

/// Fixes that contradict a dead reckoning: no estimate is valid and more than five of its sigmas
/// wrong for longer than 2 s.
namespace drydock::pipeline::dead_reckoning_fixes_test {
namespace {

using namespace reckoning_runs;
using Eigen::Vector2d;

TEST(DeadReckoningFixes, AFixThatIsFarOffIsLeftOutAndCounted) {
  Reckoning run(by_log());
  sail(run, 120, [](double s) {
    return Lies{.fix = s == 80 ? Vector2d{1000, 0} : Vector2d{0, 0}};
  });
  EXPECT_LT(judged(run.all).wrong_s, 0.1);
  EXPECT_EQ(run.estimator.status().rejected, 2u);  // rows
  EXPECT_NEAR(run.offset().x(), 240, 0.2);
  EXPECT_LE(judged(run.all).invalid, 3);  // until the next fix
}

/// 30 m to the east for 30 s: the fixes may be right, so it is not valid. When it has gone over to
/// them it knows that the track that it left may have been.
TEST(DeadReckoningFixes, FixesThatContradictTheTrackEndItsValidityAndItComesBack) {
  Reckoning run(by_log());
  sail(run, 200, [](double s) {
    return Lies{.fix = within(s, 80, 110) ? Vector2d{0, 30} : Vector2d{0, 0}};
  });
  EXPECT_LT(judged(run.all).wrong_s, 2);
  EXPECT_GE(judged(run.all).invalid, 30);
  EXPECT_TRUE(run.all.back().integrity.valid);
  EXPECT_NEAR(run.offset().y(), 0, 0.5);
  EXPECT_GE(run.estimator.status().divergences, 1u);
}

TEST(DeadReckoningFixes, FixesThatDriftAwayAreSeenBeforeTheTrackFollows) {
  for (const double rate : {0.3, 1.5, 4.0}) {
    Reckoning run(by_log());
    sail(run, 200, [&](double s) {
      return Lies{.fix = Vector2d{0, within(s, 80, 110) ? rate * std::min(20.0, s - 80) : 0}};
    });
    EXPECT_LT(judged(run.all).wrong_s, 2) << rate;
    EXPECT_TRUE(run.all.back().integrity.valid) << rate;
  }
}

/// The track was wrong, the fixes are right, and stay: after ten seconds of contradiction (and five
/// fixes that make one) it goes on at them.
TEST(DeadReckoningFixes, ATrackThatWasWrongGoesOnAtTheFixes) {
  Reckoning run(by_log());
  sail(run, 100, [](double) { return Lies{.fix = Vector2d{0, -40}}; });
  sail(
      run, 130, [](double) { return Lies{}; }, 100.2);
  EXPECT_EQ(run.estimator.status().divergences, 1u);
  EXPECT_NEAR(run.offset().y(), 0, 0.5);
  EXPECT_TRUE(run.all.back().integrity.valid);
  // The bound reaches back to the track that it left.
  EXPECT_NEAR(std::sqrt(run.all.back().covariance(1, 1)), 40, 1);
}

/// The log says nothing for 30 s while the vehicle goes on; the fixes do. The track begins again at
/// the last of them: it is as good as a fix and one second of way.
TEST(DeadReckoningFixes, AGapOfSpeedsEndsAtTheLastFixInIt) {
  Reckoning run(by_log());
  sail(run, 130, [](double s) {
    Lies lies;
    if (within(s, 80, 110)) lies.log.reset();
    return lies;
  });
  EXPECT_LT(judged(run.all).wrong_s, 0.1);
  EXPECT_EQ(run.estimator.status().bridged, 1u);
  const auto back = std::ranges::find_if(
      run.all, [](const auto& estimate) { return estimate.valid_at >= test::at_ms(110'000); });
  EXPECT_NEAR(frame::ned_offset(start, back->position).x(), 220, 0.3);
  EXPECT_LT(std::sqrt(back->covariance(0, 0)), 0.3);
}

TEST(DeadReckoningFixes, AReceiverWhoseTimesAreWrongIsLeftOutWhileAFindingSaysSo) {
  Reckoning run(by_log());
  sail(run, 80, [](double) { return Lies{}; });
  run.estimator.doubt(gnss_device, true);
  EXPECT_EQ(run.take(fix(80'500, {163, 0, 0}, 0.1)), Outcome::unused);
  run.estimator.doubt(gnss_device, false);
  EXPECT_EQ(run.take(fix(81'000, {162, 0, 0}, 0.1)), Outcome::accepted);
}

}  // namespace
}  // namespace drydock::pipeline::dead_reckoning_fixes_test
