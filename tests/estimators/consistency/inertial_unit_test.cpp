#include "estimators/consistency/inertial_unit.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "drivers/measurement/units.hpp"
#include "estimators/frame/earth.hpp"

namespace drydock::consistency {
namespace {

using Eigen::Vector3d;

constexpr double latitude_rad = std::numbers::pi / 5;  // 36 degrees
constexpr double quarter_turn_s = 10;

/// A level vehicle at one place: it lies for a while, turns by 90 degrees, lies again, and so on.
/// Its perfect gyros turn with the Earth too.
class Level {
 public:
  /// Gives the largest tilt of the unit's level from `from_s` on, rad.
  double worst_tilt(double from_s, double until_s, double leg_s) {
    double worst = 0;
    for (double time_s = 0; time_s < until_s; time_s += 0.2) {
      take(time_s, leg_s);
      if (!unit_.advance(at(time_s - 0.1))) continue;
      unit_.level(Vector3d::Zero(), true);
      if (time_s > from_s) worst = std::max(worst, unit_.down().head<2>().norm());
    }
    return worst;
  }

 private:
  static Stamp at(double time_s) { return Stamp{} + measurement::from_seconds(1000 + time_s); }

  void take(double time_s, double leg_s) {
    const double in_leg = std::fmod(time_s, leg_s);
    const double rate = in_leg < leg_s - quarter_turn_s ? 0 : std::numbers::pi / 2 / quarter_turn_s;
    const Vector3d earth =
        Eigen::AngleAxisd(-heading_, Vector3d::UnitZ()) * frame::earth_rate_ned(latitude_rad);
    measurement::ImuSample sample;
    sample.origin.valid_at = at(time_s);
    sample.angular_rate = earth + rate * Vector3d::UnitZ();
    sample.specific_force = -units::standard_gravity * Vector3d::UnitZ();
    unit_.take(sample);
    heading_ += rate * 0.2;
  }

  InertialUnit unit_{0, {.rate_hz = 5}};
  double heading_ = 0;
};

TEST(InertialUnit, TheTurnOfTheEarthTiltsTheLevelByItsRateTimesTheMemoryAtFirst) {
  // The level's error e obeys e' = w - e / 60 s: 60 s times w cos(latitude).
  EXPECT_NEAR(Level{}.worst_tilt(0, 250, 1e6),
              60 * frame::wgs84::earth_rate_radps * std::cos(latitude_rad), 0.0008);
}

TEST(InertialUnit, LearnsTheTurnOfTheEarthWhileTheVehicleTurns) {
  EXPECT_LT(Level{}.worst_tilt(3600, 7200, 75), 0.0006);
  EXPECT_LT(Level{}.worst_tilt(3600, 7200, 600), 0.0006);
}

}  // namespace
}  // namespace drydock::consistency
