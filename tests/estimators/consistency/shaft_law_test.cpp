#include "estimators/consistency/shaft_law.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace drydock::consistency {
namespace shaft_law_test {

/// A hull of m = 100 m that makes 0.012 m a radian of its shaft, integrated in steps of 10 ms. Each
/// 75 s its shaft goes to the other of two speeds. Its law is denied where it is off by 0.3 m/s.
class Voyage {
 public:
  void sail(double seconds, double said_wrong_radps = 0) {
    constexpr double dt = 0.2, step = 0.01;
    for (int i = 0; i < std::lround(seconds / dt); ++i, at_s += dt) {
      const double shaft = std::fmod(at_s, 150) < 75 ? 150 : 100;
      for (int k = 0; k < std::lround(dt / step); ++k)
        speed_mps += step * (std::pow(0.012 * shaft, 2) - speed_mps * speed_mps) / 100;
      const bool denied = law.answer() && std::abs(off()) > 0.3;
      law.take({.shaft_radps = shaft + said_wrong_radps, .speed_mps = speed_mps}, dt, !denied,
               denied);
      if (law.begins_anew()) begun_anew_s = at_s;
    }
  }
  double off() const { return law.answer()->speed_mps - speed_mps; }

  ShaftLaw law;
  double speed_mps = 1.6, at_s = 0, begun_anew_s = 0;
};

TEST(ShaftLaw, ThatAFaultTaughtBeginsAnewWhenASecondIsAsOldAndFits) {
  Voyage voyage;
  voyage.sail(60, 300);  // 60 s of three times the turns
  voyage.sail(340);
  EXPECT_GT(voyage.begun_anew_s, 60 + 120) << "a trial lasts 2 minutes at least";
  EXPECT_LT(voyage.begun_anew_s, 400);
  for (int i = 0; i < 10; ++i) {
    voyage.sail(30);
    EXPECT_NEAR(voyage.off(), 0, 0.05) << voyage.at_s;
  }
}

TEST(ShaftLaw, StaysWhereAFaultIsShorterThanItHasLearned) {
  Voyage voyage;
  voyage.sail(600);
  voyage.sail(550, 60);
  EXPECT_EQ(voyage.begun_anew_s, 0);
  EXPECT_GT(std::abs(voyage.off()), 0.3) << "the fault is seen to its end";
  voyage.sail(300);
  EXPECT_EQ(voyage.begun_anew_s, 0);
  EXPECT_NEAR(voyage.off(), 0, 0.05);
}

// No law of a hull fits turns that grow without end.
TEST(ShaftLaw, IsNotReplacedByOneOfTurnsThatDrift) {
  Voyage voyage;
  voyage.sail(200);
  for (double drift_radps = 0; drift_radps < 300; drift_radps += 3) voyage.sail(3, drift_radps);
  EXPECT_EQ(voyage.begun_anew_s, 0);
}

}  // namespace shaft_law_test
}  // namespace drydock::consistency
