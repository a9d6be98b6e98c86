#include "estimators/consistency/test.hpp"

#include <gtest/gtest.h>

#include <array>
#include <boost/math/distributions/normal.hpp>
#include <cmath>

namespace drydock::consistency {
namespace {

/// A residual that jumps to ten floors; a minute later nothing is known of it for a while.
class Residuals {
 public:
  explicit Residuals(bool holds) : Residuals(TestFacts{.floor = 0.1, .holds = holds}) {}
  explicit Residuals(const TestFacts& facts) : test(facts) {}
  void go(double seconds, double value, double sigma) { go(seconds, {value, value}, sigma); }
  /// `ends`: the residual goes from the first to the second along a straight line.
  void go(double seconds, const std::array<double, 2>& ends, double sigma, bool at_fault = false) {
    const int steps = static_cast<int>(5 * seconds);
    for (int i = 0; i < steps; ++i) {
      at_ += std::chrono::milliseconds{200};
      const double value = ends[0] + (ends[1] - ends[0]) * i / steps;
      test.take({.value = value, .sigma = sigma, .at_fault = at_fault}, at_);
    }
  }
  Stamp now() const { return at_; }
  Test test;

 private:
  Stamp at_{std::chrono::seconds{100}};
};

TEST(Test, ThatHoldsKeepsItsAlarmWhileItKnowsTooLittle) {
  for (const bool holds : {true, false}) {
    Residuals residuals(holds);
    residuals.go(20, 0, 0);
    residuals.go(60, 1, 0);
    ASSERT_TRUE(residuals.test.fired());
    residuals.go(20, 1, 1.7);
    EXPECT_EQ(residuals.test.fired(), holds);
  }
}

TEST(Test, ThatHoldsEndsItsAlarmWhenTheResidualIsBackThoughItKnowsLittle) {
  Residuals residuals(true);
  residuals.go(20, 0, 0);
  residuals.go(60, 1, 0);
  residuals.go(20, 0, 1.7);
  EXPECT_FALSE(residuals.test.fired());
}

// The usual spread is that of the time in which nothing else was known to be wrong.
TEST(Test, LearnsNoSpreadFromADeviationThatIsKnownToBeAnotherError) {
  Residuals residuals(false);
  residuals.go(20, 0, 0);
  residuals.go(5, 0.4, 1);
  residuals.go(1, 0, 0);
  EXPECT_NEAR(residuals.test.spread(), 0.1, 0.01) << "the floor";
}

// By (7) five floors are four more than the reference a sample, so three samples are the limit.
TEST(Test, ThatIsAcquittedForgetsWhatRoseSinceThenAndFiresAgainWhereItIsNotOver) {
  Residuals residuals(false);
  residuals.go(20, 0, 0);
  residuals.go(2, 0.5, 0);
  ASSERT_TRUE(residuals.test.fired());
  residuals.test.acquit(residuals.test.since() + std::chrono::seconds{1});
  EXPECT_TRUE(residuals.test.fired()) << "it rose before";
  residuals.test.acquit(residuals.test.since());
  EXPECT_FALSE(residuals.test.fired());
  EXPECT_EQ(residuals.test.suspicion(), 0);
  residuals.go(2, 0.5, 0);
  EXPECT_TRUE(residuals.test.fired());
}

/// 0.12 in 15 s is less than it may wander: it is followed until the device shows its fault.
TEST(Test, ForgetsWhatItLearnedOfADeviceAtFaultAndKeepsWhatItKnewBefore) {
  Residuals residuals(TestFacts{.floor = 0.1, .wander = 0.01});
  residuals.go(60, 0, 0);
  const Stamp since = residuals.now();
  residuals.go(15, {0, 0.12}, 0);
  residuals.go(40, {0.12, 0.12}, 0, true);
  ASSERT_FALSE(residuals.test.fired());
  ASSERT_GT(residuals.test.offset(), 0.04);
  residuals.test.forget(since);
  EXPECT_TRUE(residuals.test.learned());
  EXPECT_NEAR(residuals.test.offset(), 0, 1e-9);
  residuals.go(20, 0, 0);
  EXPECT_EQ(residuals.test.suspicion(), 0);
}

TEST(Test, ThatLearnedAllInAFaultLearnsAnew) {
  Residuals residuals(TestFacts{.floor = 0.1, .wander = 0.01});
  const Stamp since = residuals.now();
  residuals.go(20, 1, 0);
  residuals.test.forget(since);
  EXPECT_FALSE(residuals.test.learned());
  residuals.go(20, 0, 0);
  EXPECT_NEAR(residuals.test.offset(), 0, 1e-9);
  EXPECT_FALSE(residuals.test.fired());
}

TEST(Test, LearnsNothingWhileItsDeviceIsAtFault) {
  Residuals residuals(TestFacts{.floor = 0.1, .wander = 0.01});
  residuals.go(20, {5, 5}, 0, true);
  EXPECT_FALSE(residuals.test.learned());
  residuals.go(20, 0, 0);
  residuals.go(40, {0.05, 0.05}, 0, true);
  EXPECT_NEAR(residuals.test.offset(), 0, 1e-9);
}

/// 2 is twenty floors. In the second time the residual is sound, or as wide as it always is.
TEST(Test, LearnsOnceMoreWhereItsFirstSamplesScatterByFarMoreThanItsFloor) {
  for (const bool always : {false, true}) {
    Residuals residuals(TestFacts{.floor = 0.1});
    residuals.go(5, 0, 0);
    residuals.go(5.2, 2, 0);
    EXPECT_FALSE(residuals.test.learned());
    residuals.go(5, 0, 0);
    residuals.go(5.2, always ? 2 : 0, 0);
    EXPECT_TRUE(residuals.test.learned());
    if (!always) EXPECT_NEAR(residuals.test.offset(), 0, 0.03);
  }
}

/// A noisy fault of 80 s leaves a sum 0.36 m away. At its mean rate, 4.5 mm/s, the fault would need
/// three minutes to move the sum by ten sigmas. But sound sums wander by up to 30 mm/s.
TEST(Test, OfASumThatRestsForHalfAMinuteIsOver) {
  Residuals residuals(TestFacts{.floor = 0.08, .wander = 0.03, .sum_above = 0});
  residuals.go(20, 0, 0);
  residuals.go(10, {0, 0.9}, 0);
  for (int i = 0; i < 3; ++i) {
    residuals.go(10, {0.9, 0.4}, 0);
    residuals.go(10, {0.4, 0.9}, 0);
  }
  residuals.go(10, {0.9, 0.36}, 0);
  ASSERT_TRUE(residuals.test.fired());
  residuals.go(25, 0.36, 0);
  EXPECT_TRUE(residuals.test.fired());
  residuals.go(20, 0.36, 0);
  EXPECT_FALSE(residuals.test.fired());
}

/// The first ten seconds are a turn in which the law of a shaft errs by 0.17 m/s, as it may.
TEST(Test, OfWhatPassesKnowsItsOffsetNoBetterThanWhatItLearnedItFrom) {
  Residuals residuals(TestFacts{.floor = 0.025, .holds = true, .passes = true});
  residuals.go(10, 0.17, 0.2);
  for (int i = 0; i < 60; ++i) {
    residuals.go(1, 0, 0.01);
    ASSERT_FALSE(residuals.test.fired()) << i << " s behind the turn";
  }
  EXPECT_NEAR(residuals.test.offset(), 0, 0.01);
  residuals.go(4, 0.17, 0.01);
  EXPECT_TRUE(residuals.test.fired());
}

/// A shaft that turns steadily says one value again and again.
TEST(Test, OfWhatIsOftenEqualSaysThatItHasStoppedWhereTheOthersMoveFromIt) {
  for (const bool others_move : {true, false}) {
    consistency::Test test(TestFacts{.floor = 0.025, .is_often_equal = true});
    Freeze own;
    for (int i = 0; i < 150; ++i) {
      const Stamp at = Stamp{std::chrono::milliseconds{100'000 + 200 * i}};
      const double off = std::max(0, i - 100) * 0.01;
      own.see(at, 0);
      test.take({.value = off, .quantity = 2 - (others_move ? off : 0)}, at);
    }
    ASSERT_TRUE(test.fired());
    EXPECT_EQ(test.sign(&own), others_move ? diagnosis::Sign::stuck : diagnosis::Sign::ramp);
  }
}

// The last three of ten seconds of learning are of a fault that grows to -2 and ends.
TEST(Test, BesideASumThatLearnedTheBeginOfAFaultLearnsAnewWhenTheFaultIsOver) {
  Residuals residuals(TestFacts{.floor = 0.1, .others_wander = 0.001});
  residuals.go(7, 0, 0);
  residuals.go(3, {0, -0.5}, 0);
  ASSERT_LT(residuals.test.offset(), -0.15) << "a floor and a half";
  residuals.go(10, {-0.5, -2}, 0);
  ASSERT_TRUE(residuals.test.fired());
  residuals.go(30, 0, 0);
  EXPECT_FALSE(residuals.test.fired());
  EXPECT_NEAR(residuals.test.offset(), 0, 1e-9);
}

// The offset is known for a minute when the fault comes, which then changes its sign.
TEST(Test, ThatKnewItsOffsetLongBeforeGoesOnToAccuse) {
  Residuals residuals(false);
  residuals.go(80, 0, 0);
  residuals.go(10, -2, 0);
  residuals.go(60, 2, 0);
  EXPECT_TRUE(residuals.test.fired());
  EXPECT_NEAR(residuals.test.offset(), 0, 0.05);
}

// The offset follows a fault that begins slowly by some sigmas. Where the residual was before, it
// rests again.
TEST(Test, WhoseOffsetFollowedTheBeginOfAFaultEndsItsAlarmWithTheFault) {
  Residuals residuals(TestFacts{.floor = 0.1, .wander = 0.02});
  residuals.go(80, 0, 0);
  residuals.go(18, {0, 0.3}, 0);
  residuals.go(10, {0.3, 3}, 0);
  ASSERT_TRUE(residuals.test.fired());
  EXPECT_GT(residuals.test.offset(), 0.15);
  residuals.go(10, {3, 0}, 0);
  residuals.go(20, 0, 0);
  EXPECT_FALSE(residuals.test.fired());
  EXPECT_NEAR(residuals.test.offset(), 0, 0.02);
}

// Those that it is compared with followed its slow fault, so now it lies on their other side: by no
// more than they could follow.
TEST(Test, BesideASumThatFollowedItsFaultIsAccusedNoLongerWhenItIsOver) {
  for (const auto& [rest, accused] : {std::pair{-0.35, false}, {-4.0, true}}) {
    Residuals residuals(TestFacts{.floor = 0.08, .wander = 0.005, .others_wander = 0.06});
    residuals.go(80, 0, 0);
    residuals.go(20, {0, 0.35}, 0);
    residuals.go(60, rest, 0);
    EXPECT_EQ(residuals.test.fired(), accused) << rest;
  }
}

// Twenty of the first fifty samples are of a fault that is over before the learning is.
TEST(Test, LearnsTheOffsetThoughAFaultIsInItsFirstSamples) {
  Residuals residuals(false);
  residuals.go(4, 0, 0);
  residuals.go(4, 0.45, 0);
  residuals.go(2, 0, 0);
  ASSERT_TRUE(residuals.test.learned());
  EXPECT_NEAR(residuals.test.offset(), 0, 1e-9);
  residuals.go(60, 0, 0);
  EXPECT_FALSE(residuals.test.fired());
}

// The quantiles of a Gaussian distribution: its median is 0 and its variance 1.
TEST(FirstResiduals, TellMiddleAndScatterOfSamplesOfWhichSomeAreWild) {
  FirstResiduals<50> gaussian, wild;
  for (int i = 0; i < 50; ++i) {
    const double sample = quantile(boost::math::normal(), (i + 0.5) / 50);
    gaussian.add(sample);
    wild.add(i % 5 == 0 ? 1000 : sample);  // each fifth
  }
  EXPECT_NEAR(gaussian.median(), 0, 0.03);
  EXPECT_NEAR(gaussian.mean_square(), 1, 0.05);
  EXPECT_LT(std::abs(wild.median()), 0.5) << "of a deviation: the quantile of 5 / 8 is 0.32";
  EXPECT_LT(wild.mean_square(), 5);
}

}  // namespace
}  // namespace drydock::consistency
