#include "estimators/consistency/levels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "drivers/measurement/units.hpp"

namespace drydock::consistency {
namespace {

using namespace measurement;

/// One inertial unit of a level vehicle that goes straight on and then turns at a constant rate.
class Vehicle {
 public:
  /// `knows_velocity`: another device tells the vehicle's velocity.
  explicit Vehicle(bool knows_velocity = true) : knows_velocity_(knows_velocity) {}

  /// `bias`: of the gyros, rad/s.
  void go(double seconds, double turn_radps, const Eigen::Vector3d& bias, double speed_mps) {
    for (const double end_s = t_s_ + seconds; t_s_ < end_s; t_s_ += 0.01) {
      ImuSample sample;
      sample.origin.valid_at = Stamp{} + from_seconds(t_s_ + 100);
      sample.angular_rate = Eigen::Vector3d{0, 0, turn_radps} + bias;
      sample.specific_force = {0, speed_mps * turn_radps, fall_mps2_ - units::standard_gravity};
      tracks_.units[0].take(sample);
      if (++samples_ % 20 == 0)
        step(Eigen::Vector3d{0, speed_mps * turn_radps, fall_mps2_} + misread_);
    }
  }

  /// From now on another device tells the velocity, or none.
  void knows_velocity(bool known) { knows_velocity_ = known; }
  /// From now on the vehicle is accelerated downwards.
  void fall(double mps2) { fall_mps2_ = mps2; }

  /// From now on what the other device tells of the acceleration is off by this.
  void misread(const Eigen::Vector3d& mps2) { misread_ = mps2; }

  /// From now on another device tells the level.
  void knows_level() { knows_level_ = true; }

  double most_suspicion() const { return most_suspicion_; }
  double suspicion() const {
    const auto& tests = levels_.units()[0].tests;
    return std::ranges::max_element(tests, {}, &consistency::Test::suspicion)->suspicion();
  }

 private:
  void step(const Eigen::Vector3d& acceleration) {
    const Stamp at = Stamp{} + from_seconds(t_s_ + 99.8);
    Moment moment{.at = at, .dt = 0.2};
    if (knows_level_) {
      moment.down = Eigen::Vector3d::UnitZ();
      moment.level_from.push_back(1);
    }
    if (tracks_.units[0].advance(at))
      levels_.step(moment, knows_velocity_ ? std::optional(acceleration) : std::nullopt);
    most_suspicion_ = std::max(most_suspicion_, suspicion());
  }

  Tracks tracks_{{}, {}, {}, {InertialUnit(0, {.rate_hz = 100})}, {}, {}, {}};
  Levels levels_{tracks_};
  bool knows_velocity_, knows_level_ = false;
  Eigen::Vector3d misread_ = Eigen::Vector3d::Zero();
  double t_s_ = 0, most_suspicion_ = 0, fall_mps2_ = 0;
  long samples_ = 0;
};

constexpr double degree_per_hour = std::numbers::pi / 180 / 3600;
const Eigen::Vector3d none = Eigen::Vector3d::Zero();

/// The pull of 60 s leaves 60 s * 9.8 m/s2 * 31 deg/h = 0.09 m/s2, to starboard as long as the
/// vehicle goes straight on. After half a turn it stands to port: 0.18 m/s2 beside what is usual.
TEST(Levels, DoNotDoubtAUnitForATurnThatTurnsItsUsualError) {
  Vehicle vehicle;
  vehicle.go(600, 0, {31 * degree_per_hour, 0, 0}, 6);
  vehicle.go(55, 0.114, {31 * degree_per_hour, 0, 0}, 6);
  vehicle.go(60, 0, {31 * degree_per_hour, 0, 0}, 6);
  EXPECT_LT(vehicle.most_suspicion(), 0.5);
}

TEST(Levels, SeeAGyroThatIsOffByHalfADegreeASecondInSuchATurn) {
  Vehicle vehicle;
  vehicle.go(600, 0, {31 * degree_per_hour, 0, 0}, 6);
  vehicle.go(20, 0.114, {31 * degree_per_hour, 0, 0}, 6);
  vehicle.go(10, 0.114, {1800 * degree_per_hour, 0, 0}, 6);
  EXPECT_EQ(vehicle.most_suspicion(), 1);
}

/// A gyro whose samples came late or not at all in a turn: its level is off by 5 degrees, which
/// looks like an accelerometer that is off by 0.84 m/s2, but for the level of another unit.
TEST(Levels, BeginAnewBehindAMomentOfAGyroThatAnotherLevelContradicts) {
  for (const bool knows_level : {false, true}) {
    Vehicle vehicle;
    if (knows_level) vehicle.knows_level();
    vehicle.go(300, 0, none, 1);
    vehicle.go(0.2, 0, {0, 25 * std::numbers::pi / 180, 0}, 1);
    vehicle.go(3, 0, none, 1);
    EXPECT_EQ(vehicle.suspicion(), 1);
    vehicle.go(17, 0, none, 1);
    EXPECT_EQ(vehicle.suspicion(), knows_level ? 0 : 1);
  }
}

/// At 6 m/s and 0.15 rad/s the vehicle is pulled to starboard by 0.9 m/s2, which nobody else knows.
TEST(Levels, DoNotDoubtAUnitForATurnWhereNobodyKnowsTheSpeed) {
  Vehicle vehicle(false);
  vehicle.go(300, 0, none, 6);
  for (const double turn : {0.15, -0.15, 0.15}) vehicle.go(60, turn, none, 6);
  vehicle.go(120, 0, none, 6);
  EXPECT_LT(vehicle.most_suspicion(), 0.5);
}

TEST(Levels, SeeAGyroThatIsOffStraightAheadWhereNobodyKnowsTheSpeed) {
  Vehicle vehicle(false);
  vehicle.go(300, 0, none, 6);
  vehicle.go(30, 0, {1800 * degree_per_hour, 0, 0}, 6);
  EXPECT_EQ(vehicle.most_suspicion(), 1);
}

/// A body in flight feels its drag only: |f| of 1 m/s2 is an acceleration of 8.8 m/s2 at least.
TEST(Levels, DoNotDoubtAUnitThatFallsWhenNobodyKnowsTheSpeedAnyMore) {
  Vehicle vehicle;
  vehicle.fall(8.8);
  vehicle.go(43, 0, none, 300);
  vehicle.knows_velocity(false);
  vehicle.go(17, 0, none, 300);
  vehicle.knows_velocity(true);
  vehicle.go(26, 0, none, 300);
  EXPECT_LT(vehicle.most_suspicion(), 0.5);
}

/// Of 700 m/s at 45 degrees, a pitch that errs by 6 deg/s makes 70 m/s2.
TEST(Levels, DoNotDoubtAUnitThatFallsForTheAccelerationOfAReceiver) {
  Vehicle vehicle;
  vehicle.fall(8.8);
  vehicle.go(20, 0, none, 700);
  vehicle.misread({-70, 0, 0});
  vehicle.go(5, 0, none, 700);
  vehicle.misread(none);
  vehicle.go(20, 0, none, 700);
  EXPECT_LT(vehicle.most_suspicion(), 0.5);
}

/// What nobody can see of a lander in its brake is seen again when it hangs at its rope.
TEST(Levels, SeeAGyroThatIsOffBehindAFall) {
  Vehicle vehicle(false);
  vehicle.go(100, 0, none, 1);
  vehicle.fall(8.8);
  vehicle.go(5, 0, none, 1);
  vehicle.fall(0);
  vehicle.go(60, 0, none, 1);
  EXPECT_LT(vehicle.most_suspicion(), 0.5);
  vehicle.go(30, 0, {1800 * degree_per_hour, 0, 0}, 1);
  EXPECT_EQ(vehicle.most_suspicion(), 1);
}

}  // namespace
}  // namespace drydock::consistency
