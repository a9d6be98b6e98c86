#include "hil/motion/vehicle/vehicle_trajectory.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <stdexcept>
#include <thread>

#include "estimators/frame/attitude.hpp"
#include "estimators/frame/earth.hpp"
#include "estimators/frame/geodetic.hpp"
#include "rig_config/load.hpp"
#include "tests/hil/motion/missions.hpp"

/// The NPS AUV II with autopilots.
namespace drydock::motion {
namespace vehicle_trajectory_test {

using Eigen::Vector3d;
using enum rig_config::LegKind;

rig_config::MissionConfig mission_of(std::vector<rig_config::LegConfig> legs, double speed = 3,
                                     const std::string& vehicle = "nps-auv-ii") {
  rig_config::MissionConfig mission;
  mission.latitude_rad = 36 * degree;
  mission.longitude_rad = 129 * degree;
  mission.depth_m = 20;
  mission.heading_rad = 30 * degree;
  mission.speed_mps = speed;
  mission.legs = std::move(legs);
  mission.vehicle =
      rig_config::load_vehicle(DRYDOCK_SOURCE_DIR "/rig_config/vehicles/" + vehicle + ".toml")
          .value();
  return mission;
}

/// 400 s that use every autopilot, in a current that changes with depth and time.
rig_config::MissionConfig busy_mission() {
  auto mission = mission_of(
      {{.kind = turn, .duration_s = 80, .turn_rad = 120 * degree, .speed_mps = 3},
       {.kind = dive, .duration_s = 100, .depth_change_m = 60, .speed_mps = 3, .ramp_s = 20},
       {.kind = zigzag,
        .duration_s = 120,
        .speed_mps = 2.6,
        .amplitude_rad = 15 * degree,
        .period_s = 60,
        .rate_radps = 3 * degree},
       {.kind = surface, .duration_s = 100, .speed_mps = 3, .ramp_s = 15}},
      3, "nps-auv-ii-asymmetric");
  mission.ocean.current = {{0, {0.4, -0.2, 0}}, {30, {0.1, 0.3, 0.02}}, {70, {-0.2, 0, 0}}};
  mission.ocean.tide = {.period_s = 3000, .velocity_ned_mps = {0.2, 0.1, 0}};
  return mission;
}

Vector3d through_water(const Truth& truth) {
  return truth.body_to_ned.conjugate() * (truth.velocity_ned - truth.current_ned);
}

TEST(VehicleTrajectory, AtRestInStillWaterItStaysAndFeelsGravity) {
  const VehicleTrajectory trajectory(
      mission_of({{.kind = straight, .duration_s = 60, .speed_mps = 0}}, 0), start);
  const Truth truth = trajectory.at(at_s(59.995));
  EXPECT_NEAR(truth.latitude_rad, 36 * degree, 1e-15);
  EXPECT_NEAR(truth.height_m, -20, 1e-12);
  const double g = frame::gravity(36 * degree, -20);
  EXPECT_LT((truth.specific_force - Vector3d{0, 0, -g}).norm(), 1e-12);
}

TEST(VehicleTrajectory, DriftingWithTheCurrentItFeelsCoriolisButNoDrag) {
  auto mission = mission_of({{.kind = straight, .duration_s = 600, .speed_mps = 0}}, 0);
  mission.heading_rad = 0;
  mission.ocean.current = {{0, {0, 0.5, 0}}};
  const VehicleTrajectory trajectory(mission, start);
  const Truth truth = trajectory.at(at_s(10));
  EXPECT_LT((truth.velocity_ned - Vector3d{0, 0.5, 0}).norm(), 1e-4);
  // A body at rest in water that moves east at v needs 2 w v sin(L) to the north.
  EXPECT_NEAR(truth.specific_force.x(), 2 * 7.292115e-5 * 0.5 * std::sin(36 * degree), 1e-6);
}

TEST(VehicleTrajectory, OverGroundItGoesWithTheWaterPlusTheCurrent) {
  const auto still = mission_of({{.kind = straight, .duration_s = 600, .speed_mps = 3}});
  auto moving = still;
  moving.ocean.current = {{0, {0.1, -0.3, 0}}};
  const Truth a = VehicleTrajectory(still, start).at(at_s(600));
  const Truth b = VehicleTrajectory(moving, start).at(at_s(600));
  EXPECT_LT((through_water(a) - Vector3d{3, 0, 0}).norm(), 1e-3);
  EXPECT_LT((through_water(b) - Vector3d{3, 0, 0}).norm(), 1e-3);
  const Vector3d apart = frame::ned_offset({a.latitude_rad, a.longitude_rad, a.height_m},
                                           {b.latitude_rad, b.longitude_rad, b.height_m});
  EXPECT_NEAR(apart.x(), 60, 0.1);
  EXPECT_NEAR(apart.y(), -180, 0.1);
}

TEST(VehicleTrajectory, RatesVelocityAndForceAreTheDerivativesOfTheMotion) {
  const VehicleTrajectory trajectory(busy_mission(), start);
  const double h = 1e-3;
  for (double t = 0.0137; t < 400; t += 1.2345) {
    const Truth before = trajectory.at(at_s(t - h)), now = trajectory.at(at_s(t));
    const Truth after = trajectory.at(at_s(t + h));
    const Vector3d moved =
        frame::ned_offset({before.latitude_rad, before.longitude_rad, before.height_m},
                          {after.latitude_rad, after.longitude_rad, after.height_m});
    EXPECT_LT((moved / (2 * h) - now.velocity_ned).norm(), 2e-6) << "at " << t;
    const Eigen::AngleAxisd turned(before.body_to_ned.conjugate() * after.body_to_ned);
    EXPECT_LT((turned.angle() * turned.axis() / (2 * h) - now.rate_body).norm(), 1e-7) << t;
    const Vector3d acceleration = (after.velocity_ned - before.velocity_ned) / (2 * h);
    const Vector3d turning =
        2 * frame::earth_rate_ned(now.latitude_rad) +
        frame::transport_rate_ned(now.latitude_rad, now.height_m, now.velocity_ned);
    const Vector3d gravity{0, 0, frame::gravity(now.latitude_rad, now.height_m)};
    const Vector3d force =
        now.body_to_ned.conjugate() * (acceleration + turning.cross(now.velocity_ned) - gravity);
    EXPECT_LT((force - now.specific_force).norm(), 1e-6) << t;
    EXPECT_LT(
        ((after.angular_rate - before.angular_rate) / (2 * h) - now.angular_acceleration.value())
            .norm(),
        2e-6)
        << t;
  }
}

TEST(VehicleTrajectory, NothingJumpsFromStepToStep) {
  const VehicleTrajectory trajectory(busy_mission(), start);
  for (int i = 1; i < 400; ++i) {
    const Truth before = trajectory.at(at_s(i) - std::chrono::nanoseconds{1});
    const Truth after = trajectory.at(at_s(i));
    EXPECT_LT((before.velocity_ned - after.velocity_ned).norm(), 1e-8) << i;
    EXPECT_LT((before.specific_force - after.specific_force).norm(), 1e-7) << i;
    EXPECT_LT((before.angular_rate - after.angular_rate).norm(), 1e-8) << i;
    EXPECT_LT(std::abs(before.rudder_rad - after.rudder_rad), 1e-9) << i;
  }
}

std::vector<double> bits(const Truth& t) {
  return {t.latitude_rad,       t.longitude_rad,      t.height_m,         t.velocity_body.x(),
          t.specific_force.y(), t.specific_force.z(), t.angular_rate.y(), t.rudder_rad};
}

RC_GTEST_PROP(VehicleTrajectory, AnswersWithTheSameBitsInAnyOrder, ()) {
  // A quarter more times than the trajectory keeps in memory. One of the two has had many other
  // requests.
  const auto times = *rc::gen::container<std::vector<int>>(8, rc::gen::inRange(-1000, 52'000));
  static const VehicleTrajectory one(busy_mission(), start);
  const VehicleTrajectory other(busy_mission(), start);
  std::vector<std::vector<double>> forward;
  for (const int ms : times) forward.push_back(bits(one.at(at_s(ms * 1e-3))));
  for (std::size_t i = times.size(); i-- > 0;)
    RC_ASSERT(bits(other.at(at_s(times[i] * 1e-3))) == forward[i]);
}

TEST(VehicleTrajectory, AnswersTwoThreadsWithTheSameBitsAsOne) {
  const VehicleTrajectory shared(busy_mission(), start), alone(busy_mission(), start);
  std::vector<std::vector<double>> early, late;
  std::thread first([&] {
    for (int i = 0; i < 300; ++i) early.push_back(bits(shared.at(at_s(0.1 * i))));
  });
  std::thread second([&] {
    for (int i = 0; i < 300; ++i) late.push_back(bits(shared.at(at_s(120 - 0.2 * i))));
  });
  first.join();
  second.join();
  for (int i = 0; i < 300; i += 7) {
    EXPECT_EQ(early[static_cast<std::size_t>(i)], bits(alone.at(at_s(0.1 * i))));
    EXPECT_EQ(late[static_cast<std::size_t>(i)], bits(alone.at(at_s(120 - 0.2 * i))));
  }
}

TEST(VehicleTrajectory, ATurningCircleHasTheRadiusOfTheManeuverAndItsHeadingIsKept) {
  const VehicleTrajectory trajectory(
      mission_of({{.kind = turning_circle,
                   .duration_s = 300,
                   .speed_mps = 1.885,
                   .rudder_rad = 10 * degree},
                  {.kind = straight, .duration_s = 100, .speed_mps = 1.885}},
                 1.885),
      start);
  // docs/world/maneuver.md and models.md: a rudder of 10 deg gives a circle of 29.4 m radius, to
  // port.
  const Truth circling = trajectory.at(at_s(290));
  EXPECT_NEAR(circling.rudder_rad, 10 * degree, 1e-9);
  const double rate_of_turn = circling.rate_body.z() / std::cos(circling.pitch_rad);
  EXPECT_LT(rate_of_turn, 0);
  EXPECT_NEAR(circling.velocity_body.norm() / -rate_of_turn, 29.44, 0.5);
  const Truth leaving = trajectory.at(at_s(300)), steady = trajectory.at(at_s(399));
  EXPECT_NEAR(frame::wrap_pi(steady.yaw_rad - leaving.yaw_rad), 0, 2 * degree);
  EXPECT_NEAR(steady.rate_body.z(), 0, 1e-3);
}

TEST(VehicleTrajectory, TheActuatorsKeepToTheirStopsAndRates) {
  auto mission = busy_mission();
  mission.legs.push_back(
      {.kind = turn, .duration_s = 20, .turn_rad = 170 * degree, .speed_mps = 3});  // too sharp
  const VehicleTrajectory trajectory(mission, start);
  double largest_rudder = 0, fastest_rudder = 0;
  Truth before = trajectory.at(start);
  for (double t = 0.05; t < 420; t += 0.05) {
    const Truth now = trajectory.at(at_s(t));
    largest_rudder = std::max(largest_rudder, std::abs(now.rudder_rad));
    fastest_rudder = std::max(fastest_rudder, std::abs(now.rudder_rad - before.rudder_rad) / 0.05);
    EXPECT_LE(std::abs(now.stern_plane_rad), 20 * degree + 1e-12);
    EXPECT_LE(std::abs(now.stern_plane_rad - before.stern_plane_rad) / 0.05, 2.5 * degree + 1e-9);
    EXPECT_LE(now.propeller_radps, 2500 * 2 * std::numbers::pi / 60 + 1e-9);
    EXPECT_LT(std::abs(now.pitch_rad), 35 * degree);
    before = now;
  }
  EXPECT_NEAR(largest_rudder, 20 * degree, 1e-6);  // the sharp turn needs the full rudder
  EXPECT_NEAR(fastest_rudder, 2.5 * degree, 1e-6);
}

TEST(VehicleTrajectory, SteadyErrorsOfAnAsymmetricHullAreTrimmedAway) {
  const VehicleTrajectory trajectory(
      mission_of({{.kind = straight, .duration_s = 600, .speed_mps = 2.5}}, 2.5,
                 "nps-auv-ii-asymmetric"),
      start);
  const Truth truth = trajectory.at(at_s(600));
  EXPECT_NEAR(truth.yaw_rad, 30 * degree, 0.01 * degree);
  EXPECT_NEAR(truth.height_m, -20, 0.01);
  EXPECT_NEAR(through_water(truth).x(), 2.5, 1e-3);
  EXPECT_GT(std::abs(truth.rudder_rad), 1e-4);
}

std::string refusal(const rig_config::MissionConfig& mission) {
  try {
    const VehicleTrajectory trajectory(mission, start);
    return "sailed";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

TEST(VehicleTrajectory, RefusesWhatTheVehicleCannotSail) {
  EXPECT_EQ(refusal(mission_of({{.kind = straight, .duration_s = 100, .speed_mps = 4}})),
            "mission: after 29 s the vehicle would need 3.15 m/s, its propeller gives 3.14");
  EXPECT_EQ(refusal(mission_of(
                {{.kind = dive, .duration_s = 100, .depth_change_m = 75, .speed_mps = 3}})),
            "mission leg 1: this dive needs a pitch above 30 deg; allow more time, speed or less "
            "depth");
  auto shallow = mission_of({{.kind = straight, .duration_s = 600, .speed_mps = 3}});
  shallow.ocean.bed.kind = rig_config::BedKind::slope;
  shallow.ocean.bed.depth_m = 50;
  shallow.ocean.bed.gradient = 0.02;
  shallow.ocean.bed.downhill_rad = 210 * degree;
  EXPECT_EQ(refusal(shallow).substr(0, 61),
            "mission: after 500 s the vehicle would be 20.0 m deep, at or ");
}

}  // namespace vehicle_trajectory_test
}  // namespace drydock::motion
