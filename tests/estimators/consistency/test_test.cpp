#include "estimators/consistency/test.hpp"

#include <gtest/gtest.h>

namespace drydock::consistency {
namespace {

/// A residual that jumps to ten floors; a minute later nothing is known of it for a while.
class Residuals {
 public:
  explicit Residuals(bool holds) : test({.floor = 0.1, .holds = holds}) {}
  void go(double seconds, double value, double sigma) {
    for (int i = 0; i < 5 * seconds; ++i) {
      at_ += std::chrono::milliseconds{200};
      test.take({.value = value, .sigma = sigma}, at_);
    }
  }
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

}  // namespace
}  // namespace drydock::consistency
