#include "hil/motion/ballistic_trajectory.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <stdexcept>

#include "estimators/frame/attitude.hpp"
#include "hil/motion/make_trajectory.hpp"
#include "tests/hil/motion/mechanization.hpp"
#include "tests/hil/motion/missions.hpp"

namespace drydock::motion {
namespace {

using Eigen::Vector3d;

/// The roll paper's flight: roll rate 0.25 Hz, pitch from +45 to -45 deg in about 100 s.
rig_config::MissionConfig rocket() {
  rig_config::MissionConfig mission;
  mission.latitude_rad = 36 * degree;
  mission.longitude_rad = 129 * degree;
  mission.heading_rad = 70 * degree;
  mission.speed_mps = 700;
  mission.ballistic = rig_config::BallisticConfig{.height_m = 100,
                                                  .elevation_rad = 45 * degree,
                                                  .ballistic_coefficient_kgm2 = 20000,
                                                  .roll_rate_radps = 90 * degree,
                                                  .roll_rad = 30 * degree,
                                                  .spin_up_s = 4,
                                                  .angle_of_attack_rad = 0.5 * degree,
                                                  .coning_radps = 360 * degree};
  return mission;
}

/// The same without air, roll and cone, launched at sea level.
rig_config::MissionConfig thrown() {
  auto mission = rocket();
  mission.ballistic = rig_config::BallisticConfig{.elevation_rad = 45 * degree};
  return mission;
}

Vector3d travelled(const Truth& from, const Truth& to) {
  return frame::ned_offset({from.latitude_rad, from.longitude_rad, from.height_m},
                           {to.latitude_rad, to.longitude_rad, to.height_m});
}

TEST(BallisticTrajectory, AnIndependentMechanizationOfItsImuFindsItAgain) {
  const BallisticTrajectory trajectory(rocket(), start);
  const double flight_s = measurement::seconds(trajectory.end() - start);
  EXPECT_GT(flight_s, 80);
  EXPECT_LT(flight_s, 110);
  const MechanizationError error = mechanize(trajectory, start, std::floor(flight_s), 0.01);
  EXPECT_LT(error.position_m, 0.01);
  EXPECT_LT(error.velocity_mps, 1e-4);
  EXPECT_LT(error.attitude_rad, 1e-6);
}

TEST(BallisticTrajectory, AShortThrowIsTheParabolaOfTheTextbook) {
  auto mission = thrown();
  mission.speed_mps = 50;
  const BallisticTrajectory trajectory(mission, start);
  const double g = frame::gravity(mission.latitude_rad);
  const double flight_s = 2 * 50 * std::sin(45 * degree) / g;
  EXPECT_NEAR(measurement::seconds(trajectory.end() - start), flight_s, 2e-3 * flight_s);
  const Truth top = trajectory.at(at_s(flight_s / 2));
  EXPECT_NEAR(top.height_m, 50 * 50 * 0.5 / (2 * g), 0.05);
  EXPECT_NEAR(top.pitch_rad, 0, 1e-3);
  EXPECT_NEAR(travelled(trajectory.at(start), trajectory.at(trajectory.end())).norm(), 2500 / g,
              0.5);
}

TEST(BallisticTrajectory, WithoutAirAnAccelerometerFeelsNothing) {
  const BallisticTrajectory trajectory(thrown(), start);
  for (double t = 0; t < 90; t += 7) EXPECT_LT(trajectory.at(at_s(t)).specific_force.norm(), 1e-9);
}

TEST(BallisticTrajectory, CoriolisCarriesAShotToTheNorthOffToTheEast) {
  auto mission = thrown();
  mission.heading_rad = 0;
  mission.speed_mps = 300;
  mission.ballistic->elevation_rad = 0;
  mission.ballistic->height_m = 500;
  const BallisticTrajectory trajectory(mission, start);
  const double t = 10, omega = 7.292115e-5, latitude = 36 * degree;
  // Flat Earth, first order in omega: omega v t^2 sin(L) + omega g t^3 cos(L) / 3.
  const double expected =
      omega * 300 * t * t * std::sin(latitude) + omega * 9.798 * t * t * t * std::cos(latitude) / 3;
  EXPECT_NEAR(travelled(trajectory.at(start), trajectory.at(at_s(t))).y(), expected,
              0.01 * expected);
}

TEST(BallisticTrajectory, DragIsTheDynamicPressureOverTheBallisticCoefficientAgainstTheVelocity) {
  const BallisticTrajectory trajectory(rocket(), start);
  const Truth truth = trajectory.at(start);
  const double pressure = 1.225 * std::exp(-100 / 8434.5) * 700 * 700 / 2;
  EXPECT_NEAR(truth.specific_force.norm(), pressure / 20000, 1e-9);
  EXPECT_NEAR(truth.specific_force.normalized().dot(truth.velocity_body) / 700, -1, 1e-12);
}

TEST(BallisticTrajectory, TheNoseFollowsTheVelocityWithinItsCone) {
  const BallisticTrajectory trajectory(rocket(), start);
  double largest = 0;
  for (double t = 0; t < 80; t += 0.1) {
    const Vector3d v = trajectory.at(at_s(t)).velocity_body;
    largest = std::max(largest, std::acos(v.x() / v.norm()));
  }
  EXPECT_LT(largest, 0.5001 * degree);
  EXPECT_GT(largest, 0.49 * degree);
  EXPECT_NEAR(trajectory.at(start).pitch_rad, 45 * degree, 1e-12);
  EXPECT_LT(trajectory.at(trajectory.end()).pitch_rad, -45 * degree);  // drag makes it steeper
  EXPECT_GT(trajectory.at(trajectory.end()).pitch_rad, -60 * degree);
}

TEST(BallisticTrajectory, TheRollRateIsHeldOnceItIsSpunUp) {
  const BallisticTrajectory trajectory(rocket(), start);
  EXPECT_NEAR(trajectory.at(start).rate_body.x(), 0, 0.1);
  for (const double t : {4.0, 20.0, 60.0}) {
    const double here = trajectory.at(at_s(t)).roll_rad,
                 later = trajectory.at(at_s(t + 1)).roll_rad;
    EXPECT_NEAR(frame::wrap_pi(later - here), 90 * degree, 1e-9) << t;
  }
  // The mean rate during the spin-up is half the final rate: 180 deg in 4 s.
  EXPECT_NEAR(frame::wrap_pi(trajectory.at(at_s(4)).roll_rad), -150 * degree, 1e-9);
}

TEST(BallisticTrajectory, RatesAndVelocityAreTheDerivativesOfAttitudeAndPosition) {
  const BallisticTrajectory trajectory(rocket(), start);
  const double h = 1e-3;
  for (double t = 0.5; t < 85; t += 0.37) {
    const Truth before = trajectory.at(at_s(t - h)), now = trajectory.at(at_s(t)),
                after = trajectory.at(at_s(t + h));
    EXPECT_LT((travelled(before, after) / (2 * h) - now.velocity_ned).norm(), 2e-3) << t;
    const Eigen::AngleAxisd turned(before.body_to_ned.conjugate() * after.body_to_ned);
    EXPECT_LT((turned.angle() * turned.axis() / (2 * h) - now.rate_body).norm(), 1e-5) << t;
  }
}

TEST(BallisticTrajectory, OnTheGroundItLiesStill) {
  const BallisticTrajectory trajectory(rocket(), start);
  const Truth down = trajectory.at(trajectory.end());
  const Truth later = trajectory.at(trajectory.end() + std::chrono::minutes{5});
  EXPECT_NEAR(down.height_m, 0, 1e-5);
  EXPECT_EQ(later.height_m, down.height_m);
  EXPECT_EQ(later.velocity_ned, Vector3d::Zero());
  EXPECT_EQ(later.rate_body, Vector3d::Zero());
  EXPECT_NEAR(later.specific_force.norm(), frame::gravity(later.latitude_rad, 0), 1e-6);
}

RC_GTEST_PROP(BallisticTrajectory, AnswersTheSameInAnyOrder, ()) {
  const auto seconds = *rc::gen::container<std::vector<int>>(20, rc::gen::inRange(-10, 200));
  const BallisticTrajectory one(rocket(), start), other(rocket(), start);
  std::vector<Vector3d> forward;
  for (const int t : seconds) forward.push_back(one.at(at_s(t + 0.25)).specific_force);
  for (std::size_t i = seconds.size(); i-- > 0;)
    RC_ASSERT(other.at(at_s(seconds[i] + 0.25)).specific_force == forward[i]);
}

TEST(MakeTrajectory, TheMissionChoosesTheMotion) {
  EXPECT_NE(dynamic_cast<BallisticTrajectory*>(make_trajectory(rocket(), start).get()), nullptr);
  EXPECT_NE(dynamic_cast<KinematicTrajectory*>(make_trajectory(varied_mission(), start).get()),
            nullptr);
}

TEST(MakeTrajectory, RefusesAFlightThatTheModelDoesNotHold) {
  auto mission = thrown();
  mission.speed_mps = 5000;  // reaches 600 km
  EXPECT_THROW(make_trajectory(mission, start), std::invalid_argument);
  mission = thrown();
  mission.ballistic->ground_height_m = 1;
  EXPECT_THROW(make_trajectory(mission, start), std::invalid_argument);
}

}  // namespace
}  // namespace drydock::motion
