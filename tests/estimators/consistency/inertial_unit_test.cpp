#include "estimators/consistency/inertial_unit.hpp"

#include <gtest/gtest.h>

#include <cmath>
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

/// Ten degrees a second on the spot; the level steps are those of the checks, 0.2 s. A busy
/// computer loses the samples of `hole_s` from 5.03 s on.
struct Turning {
  static constexpr double rate_radps = 10 * std::numbers::pi / 180;
  double worst_force = 0;  ///< m/s2, of the steps that are given
  int given = 0, resumed = 0;
  double heading_error = 0;  ///< rad, at the end

  explicit Turning(double hole_s) {
    InertialUnit unit{0, {.rate_hz = 100}};
    const auto at = [](int ms) { return Stamp{} + std::chrono::milliseconds{1'000'000 + ms}; };
    double first_s = 0;
    for (int ms = 0; ms <= 10'000; ms += 10) {
      if (ms <= 5030 || ms >= 5030 + std::lround(1000 * hole_s)) {
        measurement::ImuSample sample;
        sample.origin.valid_at = at(ms);
        sample.angular_rate = rate_radps * Vector3d::UnitZ();
        sample.specific_force = -units::standard_gravity * Vector3d::UnitZ();
        unit.take(sample);
      }
      // The checks are some 0.4 s behind, so that the samples around the time are there.
      const int then = ms - 400;
      if (then < 0 || then % 200 != 0) continue;
      if (!unit.advance(at(then))) continue;
      if (given++ == 0) first_s = then / 1000.0 - 0.2;
      resumed += unit.resumed() ? 1 : 0;
      worst_force = std::max(worst_force, unit.level(Vector3d::Zero(), true).norm());
      heading_error = unit.heading() - rate_radps * (then / 1000.0 - first_s);
    }
  }
};

TEST(InertialUnit, GivesNoStepWhoseSamplesWereLostAndTurnsOnOverTheHole) {
  const Turning whole(0);
  EXPECT_EQ(whole.resumed, 1) << "the start";
  for (const double hole_s : {0.11, 0.12, 0.13, 0.15, 0.19, 0.3, 0.6}) {
    const Turning turning(hole_s);
    EXPECT_LT(turning.worst_force, 1e-9) << hole_s << " s";
    EXPECT_NEAR(turning.heading_error, 0, 1e-9) << hole_s << " s";
    EXPECT_EQ(turning.resumed, 2) << hole_s << " s: start and hole";
    EXPECT_GE(turning.given, whole.given - 5) << hole_s << " s";
  }
}

/// The unit is off for 26 s, in which a dive begins: the bow comes down by 10 degrees. Nothing
/// turned the level meanwhile, so it stands where the first specific force says.
TEST(InertialUnit, FindsTheLevelAnewAfterItWasAway) {
  constexpr double pitch_rad = -10 * std::numbers::pi / 180;
  InertialUnit unit{0, {.rate_hz = 5}};
  const auto at = [](double time_s) { return Stamp{} + measurement::from_seconds(1000 + time_s); };
  const Vector3d before = Vector3d::UnitZ();
  const Vector3d behind{-std::sin(pitch_rad), 0, std::cos(pitch_rad)};
  int steps_behind = 0;
  for (int step = 0; step < 800; ++step) {
    const double time_s = 0.2 * step;
    const bool dives = time_s >= 126;
    if (time_s < 100 || dives) {
      measurement::ImuSample sample;
      sample.origin.valid_at = at(time_s);
      sample.specific_force = -units::standard_gravity * (dives ? behind : before);
      unit.take(sample);
    }
    if (!unit.advance(at(time_s - 0.1))) continue;
    EXPECT_LT(unit.level(Vector3d::Zero(), true).norm(), 1e-9) << time_s << " s";
    EXPECT_LT((unit.down() - (dives ? behind : before)).norm(), 1e-9) << time_s << " s";
    steps_behind += dives ? 1 : 0;
  }
  EXPECT_GT(steps_behind, 150);
}

/// Two samples a second, of which one is lost while the body begins to roll by 4 degrees a second:
/// it may have rolled by 2 degrees more or less than it seems. A roll that goes on tells no less.
TEST(InertialUnit, LosesItsLevelWithASampleOfARollThatBegins) {
  for (const bool rolled_before : {false, true}) {
    InertialUnit unit{0, {.rate_hz = 2}};
    const auto at = [](double time_s) {
      return Stamp{} + measurement::from_seconds(1000 + time_s);
    };
    int lost = 0;
    for (int step = 0; step < 60; ++step) {
      const double time_s = 0.5 * step;
      if (step != 40) {
        measurement::ImuSample sample;
        sample.origin.valid_at = at(time_s);
        const bool rolls = rolled_before || step > 40;
        sample.angular_rate.x() = rolls ? 4 * units::degree : 0;
        sample.specific_force = -units::standard_gravity * Vector3d::UnitZ();
        unit.take(sample);
      }
      for (const double back_s : {1.4, 1.2}) {
        unit.advance(at(time_s - back_s));
        lost += step > 10 && unit.level_lost() ? 1 : 0;
        unit.level(Vector3d::Zero(), true);
      }
    }
    EXPECT_EQ(lost > 0, !rolled_before);
  }
}

/// A unit that was stuck in a turn does not know its heading; the others do.
TEST(InertialUnit, KeepsItsLevelAxesByTheHeadingOfTheOthers) {
  InertialUnit unit{0, {.rate_hz = 5}};
  unit.follow_heading(0.5);
  const auto axes = unit.level_axes();
  ASSERT_TRUE(axes);
  EXPECT_LT((axes->col(0) - Vector3d(std::cos(0.5), -std::sin(0.5), 0)).norm(), 1e-12) << "north";
  EXPECT_LT((axes->col(1) - Vector3d(std::sin(0.5), std::cos(0.5), 0)).norm(), 1e-12) << "east";
}

TEST(InertialUnit, ASingleLostSampleLeavesEveryStep) {
  const Turning whole(0), turning(0.02);
  EXPECT_EQ(turning.given, whole.given);
  EXPECT_LT(turning.worst_force, 1e-9);
}

}  // namespace
}  // namespace drydock::consistency
