#include "estimators/consistency/surge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace drydock::consistency {
namespace surge_test {

constexpr double dt = 0.2;

/// A hull that obeys m du/dt = U^2 - u^2 with m = 100 m and U = 0.012 m n. Its speed is
/// U tanh(U t / m + atanh(u0 / U)) while it grows, and U coth(...) while it falls.
class Hull {
 public:
  void drive(double shaft_radps, double seconds, bool learn = true, double said_radps = 0) {
    const double end = 0.012 * shaft_radps, from = speed_mps;
    for (int i = 1; i <= std::lround(seconds / dt); ++i) {
      const double part = end * i * dt / 100;
      speed_mps = from < end ? end * std::tanh(part + std::atanh(from / end))
                             : end / std::tanh(part + std::atanh(end / from));
      surge.take({.shaft_radps = shaft_radps + said_radps, .speed_mps = speed_mps + noise()}, dt);
      if (learn) surge.learn();
    }
  }

  Surge surge;
  double speed_mps = 1.6;
  std::function<double()> noise = [] { return 0.0; };
};

TEST(Surge, FollowsAHullThatGainsItsSpeedOverAMinute) {
  Hull hull;
  for (const double shaft : {150.0, 110.0, 160.0, 120.0}) hull.drive(shaft, 60);
  const double before = hull.speed_mps;
  hull.drive(170, 10, false);
  ASSERT_TRUE(hull.surge.answer());
  EXPECT_LT(hull.speed_mps, 0.012 * 170 - 0.3) << "it is far from what its shaft will make";
  EXPECT_GT(hull.speed_mps, before + 0.1);
  EXPECT_NEAR(hull.surge.answer()->speed_mps, hull.speed_mps, 0.03);
  hull.drive(170, 100, false);
  EXPECT_NEAR(hull.surge.answer()->speed_mps, 0.012 * 170, 0.03);
}

TEST(Surge, IsAsUnsureAsTheHullMayBeSlowWhileItHasNotChangedItsSpeed) {
  Hull hull;
  hull.speed_mps = 0.012 * 150 - 1e-6;
  hull.drive(150, 120);
  hull.drive(100, 2, false);
  ASSERT_TRUE(hull.surge.answer());
  const auto answer = *hull.surge.answer();
  EXPECT_GT(answer.sigma_mps, std::abs(answer.speed_mps - hull.speed_mps) / 2);
}

// dw/dt of a steady hull is noise. By least squares noise alone tells a small m.
TEST(Surge, IsUnsureInTheFirstChangeOfASpeedThatWasSaidWithNoise) {
  Hull hull;
  std::mt19937 random(7);
  hull.noise = [&] { return std::normal_distribution(0.0, 0.03)(random); };
  hull.speed_mps = 0.012 * 100 - 1e-6;
  hull.drive(100, 300);
  for (int i = 0; i < 8; ++i) {
    hull.drive(70, 5, false);
    const auto answer = *hull.surge.answer();
    EXPECT_GT(answer.sigma_mps, std::abs(answer.speed_mps - hull.speed_mps) / 1.2) << 5 * i;
  }
}

// The thrust is known after 40 s, here while the hull brakes by 0.1 m/s2. It has no way of its own.
TEST(Surge, BeginsAtTheSpeedOfTheMomentWhenAHullIsBraking) {
  Surge surge;
  double speed_mps = 3;
  for (int i = 0; !surge.answer() && i < 500; ++i) {
    speed_mps = std::max(2.0, 3 - 0.1 * dt * std::max(0, i - 190));
    surge.take({.shaft_radps = speed_mps / 0.012, .speed_mps = speed_mps}, dt);
    surge.learn();
  }
  ASSERT_TRUE(surge.answer());
  ASSERT_LT(speed_mps, 2.95) << "it is braking";
  EXPECT_NEAR(surge.answer()->speed_mps, speed_mps, 0.01);
}

TEST(Surge, KnowsATurnOfTheShaftThatTheHullDoesNotFollow) {
  Hull hull;
  for (const double shaft : {150.0, 110.0, 160.0, 120.0}) hull.drive(shaft, 60);
  hull.drive(120, 40, false, 15);
  ASSERT_TRUE(hull.surge.answer());
  EXPECT_GT(hull.surge.answer()->speed_mps - hull.speed_mps, 0.1);
  EXPECT_LT(hull.surge.answer()->sigma_mps, 0.03);
}

/// A hull of m = 100 m that loses d r^2 with d = 300 m2 in its turns, ahead through water that
/// moves north by 0.3 m/s. Integrated in steps of 10 ms.
class Turning {
 public:
  void sail(double seconds, double turn_radps, bool learn, double said_radps = 0) {
    constexpr double step = 0.01, shaft = 150;
    for (int i = 0; i < std::lround(seconds / dt); ++i) {
      for (int k = 0; k < std::lround(dt / step); ++k) {
        const double steady = std::pow(0.012 * shaft, 2) - 300 * turn_radps * turn_radps;
        through_mps += step * (steady - through_mps * through_mps) / 100;
        heading += step * turn_radps;
      }
      const double current = 0.3 * std::cos(heading);
      surge.take({.shaft_radps = shaft + said_radps,
                  .speed_mps = through_mps + current,
                  .starboard_mps = -0.3 * std::sin(heading),
                  .turn_radps = turn_radps,
                  .current_mps = current,
                  .current_starboard_mps = -0.3 * std::sin(heading)},
                 dt);
      if (learn) surge.learn();
    }
  }
  double off() const { return surge.answer()->speed_mps - through_mps - 0.3 * std::cos(heading); }

  Surge surge;
  double through_mps = 0.012 * 150, heading = 0;
};

TEST(Surge, KnowsThatTheWaterTakesAHullAlongThroughASharpTurn) {
  Turning hull;
  hull.sail(60, 0, true);
  for (const double side : {1.0, -1.0, 1.0}) {
    hull.sail(25, side * 0.1, true);
    hull.sail(40, 0, true);
  }
  hull.sail(25, 0.1, false);
  EXPECT_NEAR(hull.off(), 0, 0.03);
  hull.sail(10, 0, false);
  EXPECT_NEAR(hull.off(), 0, 0.03);
  EXPECT_LT(hull.surge.answer()->sigma_mps, 0.06);
}

TEST(Surge, IsUnsureInAndAfterItsFirstSharpTurn) {
  Turning hull;
  hull.sail(60, 0, true);
  hull.sail(25, 0.1, false);
  EXPECT_GT(hull.surge.answer()->sigma_mps, std::abs(hull.off()) / 3) << "what it takes is unknown";
  hull.sail(10, 0, false);
  EXPECT_GT(hull.surge.answer()->sigma_mps, std::abs(hull.off()) / 3) << "and lasts";
}

// What the shaft makes is carried on without a rate of turn by what the others say.
TEST(Surge, GoesOnFromTheSpeedOfTheOthersWhereNothingTellsTheTurn) {
  Hull hull;
  for (const double shaft : {150.0, 110.0, 160.0, 120.0}) hull.drive(shaft, 60);
  hull.surge.take({.shaft_radps = 120, .speed_mps = 1.1, .turn_radps = {}}, dt);
  EXPECT_NEAR(hull.surge.answer()->speed_mps, 1.1, 1e-9);
}

}  // namespace surge_test
}  // namespace drydock::consistency
