#include "estimators/consistency/helm.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace drydock::consistency {
namespace {

constexpr double degree = std::numbers::pi / 180, dt = 0.2;

/// A hull that obeys Nomoto's law with a = 5 m and b = 25 m2, at 1.8 m/s. In a step the curvature
/// goes on by its closed form k = d/a + (k0 - d/a) exp(-s a / b).
class Hull {
 public:
  void steer(double rudder_rad, double seconds, bool learn) {
    for (int i = 0; i < std::lround(seconds / dt); ++i) {
      const double end = rudder_rad / a_m;
      const double before = curvature_;
      curvature_ = end + (curvature_ - end) * std::exp(-speed_mps * dt * a_m / b_m2);
      helm.take(rudder_rad, (before + curvature_) / 2, speed_mps, dt);
      if (learn) helm.learn();
    }
  }
  double curvature() const { return curvature_; }

  Helm helm;

 private:
  static constexpr double a_m = 5, b_m2 = 25, speed_mps = 1.8;
  double curvature_ = 0;
};

TEST(Helm, KnowsNoLawOnAStraightWay) {
  Hull hull;
  hull.steer(0, 600, true);
  EXPECT_FALSE(hull.helm.answer());
}

TEST(Helm, SaysWhichRudderTheHullNeedsWhileItStillBeginsToTurn) {
  Hull hull;
  for (const double side : {1.0, -1.0, 1.0, -1.0, 0.0}) hull.steer(side * 10 * degree, 20, true);
  hull.steer(10 * degree, 2, false);
  ASSERT_TRUE(hull.helm.answer());
  EXPECT_LT(hull.curvature(), 0.55 * 10 * degree / 5) << "the curvature is half of its last value";
  EXPECT_NEAR(hull.helm.answer()->rudder_rad, 10 * degree, 1e-9);
  EXPECT_NEAR(hull.helm.answer()->needed_rad, 10 * degree, 1 * degree);
  hull.steer(10 * degree, 3, false);
  EXPECT_NEAR(hull.helm.answer()->needed_rad, 10 * degree, 0.5 * degree);
}

// A hull that drifts remembers its turn for some lengths: at least 0.15 of the rudder, less by a
// factor e each 25 m.
TEST(Helm, IsLessSureBehindATurnForSomeLengths) {
  Hull hull;
  for (const double side : {1.0, -1.0, 1.0}) hull.steer(side * 10 * degree, 20, true);
  hull.steer(0, 10, false);  // 18 m
  ASSERT_TRUE(hull.helm.answer());
  EXPECT_NEAR(hull.helm.answer()->needed_rad, 0, 0.5 * degree);
  EXPECT_GT(hull.helm.answer()->sigma_rad, 0.15 * 10 * degree * std::exp(-18.0 / 25));
  hull.steer(0, 60, false);
  EXPECT_LT(hull.helm.answer()->sigma_rad, 0.2 * degree);
}

TEST(Helm, TellsARudderThatIsSaidWithTheWrongZeroFromATurn) {
  Hull hull;
  for (const double side : {1.0, -1.0, 1.0, -1.0, 0.0}) hull.steer(side * 10 * degree, 20, true);
  hull.steer(0, 30, true);  // the turns are behind it
  for (int i = 0; i < 10; ++i) hull.helm.take(5 * degree, 0, 1.8, dt);
  ASSERT_TRUE(hull.helm.answer());
  EXPECT_NEAR(hull.helm.answer()->rudder_rad - hull.helm.answer()->needed_rad, 5 * degree,
              0.5 * degree);
  EXPECT_LT(hull.helm.answer()->sigma_rad, 0.5 * degree);
}

}  // namespace
}  // namespace drydock::consistency
