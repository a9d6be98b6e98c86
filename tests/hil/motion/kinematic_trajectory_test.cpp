#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <random>
#include <stdexcept>

#include "estimators/frame/attitude.hpp"
#include "estimators/frame/earth.hpp"
#include "estimators/frame/geodetic.hpp"
#include "tests/hil/motion/mechanization.hpp"
#include "tests/hil/motion/missions.hpp"

namespace drydock::motion {
namespace {

using Eigen::Vector3d;
using rig_config::LegKind;

TEST(KinematicTrajectory, AnIndependentMechanizationOfItsImuFindsItAgain) {
  const KinematicTrajectory trajectory(varied_mission(), start);
  const MechanizationError error = mechanize(trajectory, start, 600, 0.05);
  EXPECT_LT(error.position_m, 0.01);
  EXPECT_LT(error.velocity_mps, 1e-4);
  EXPECT_LT(error.attitude_rad, 1e-6);
}

TEST(KinematicTrajectory, AtRestAnImuFeelsGravityAndTheEarthTurning) {
  rig_config::MissionConfig mission;
  mission.latitude_rad = 60 * degree;
  mission.heading_rad = 90 * degree;
  const KinematicTrajectory trajectory(mission, start);
  const Truth truth = trajectory.at(at_s(1234.5));
  // Somigliana at 60 deg: 9.819177 m/s2 (NIMA TR8350.2 constants). The heading is east, so x is
  // east and y is south.
  EXPECT_NEAR((truth.specific_force - Vector3d{0, 0, -9.819177}).norm(), 0, 2e-6);
  const double omega = 7.292115e-5;
  EXPECT_NEAR((truth.angular_rate - omega * Vector3d{0, -0.5, -0.8660254}).norm(), 0, 1e-11);
  EXPECT_NEAR(truth.latitude_rad, 60 * degree, 1e-15);
}

TEST(KinematicTrajectory, OnAStraightCourseTheForceIsGravityAndCoriolis) {
  rig_config::MissionConfig mission;
  mission.latitude_rad = 45 * degree;
  mission.speed_mps = 2;
  const KinematicTrajectory trajectory(mission, start);
  const Truth truth = trajectory.at(start);
  // Northbound at u: (2 w_ie + w_en) x v = [-u^2/R... ] reduces to east 2 w u sin(L), down
  // -u^2/R_N.
  const double coriolis = 2 * 7.292115e-5 * 2 * std::sin(45 * degree);
  EXPECT_NEAR(truth.specific_force.x(), 0, 1e-12);
  EXPECT_NEAR(truth.specific_force.y(), -coriolis, 1e-12);
  EXPECT_NEAR(truth.specific_force.z(), 4 / frame::meridian_radius(45 * degree) - 9.806198, 2e-6);
}

TEST(KinematicTrajectory, InALevelTurnTheCentripetalForceIsSpeedTimesYawRate) {
  rig_config::MissionConfig mission;
  mission.latitude_rad = 20 * degree;
  mission.speed_mps = 3;
  mission.legs = {
      {.kind = LegKind::turn, .duration_s = 100, .turn_rad = 180 * degree, .speed_mps = 3}};
  const KinematicTrajectory trajectory(mission, start);
  const Truth truth = trajectory.at(at_s(50));
  const double yaw_rate = 180 * degree / 90;  // ramps of 10 s, so the rate is held for 80 s
  EXPECT_NEAR(truth.rate_body.z(), yaw_rate, 1e-12);
  EXPECT_NEAR(truth.yaw_rad, 90 * degree, 1e-12);
  // Coriolis at 3 m/s is below 5e-4 m/s2.
  EXPECT_NEAR(truth.specific_force.y(), 3 * yaw_rate, 5e-4);
  EXPECT_NEAR(truth.specific_force.x(), 0, 5e-4);
  EXPECT_LT(truth.rudder_rad, 0);  // a turn to starboard: the rudder angle is negative by
                                   // convention
}

TEST(KinematicTrajectory, ADiveReachesItsDepthWithPitchAlongThePath) {
  rig_config::MissionConfig mission;
  mission.depth_m = 10;
  mission.speed_mps = 2;
  mission.legs = {{.kind = LegKind::dive, .duration_s = 100, .depth_change_m = 30, .speed_mps = 2}};
  const KinematicTrajectory trajectory(mission, start);
  EXPECT_NEAR(trajectory.at(at_s(100)).height_m, -40, 1e-9);
  EXPECT_NEAR(trajectory.at(at_s(50)).height_m, -25, 1e-9);
  const Truth steepest = trajectory.at(at_s(50));
  EXPECT_NEAR(std::sin(steepest.pitch_rad), -30 * 2.1875 / 100 / 2, 1e-12);
  EXPECT_NEAR(steepest.velocity_ned.z(), 2 * std::sin(-steepest.pitch_rad), 1e-12);
  EXPECT_GT(trajectory.at(at_s(25)).stern_plane_rad, 0);  // nose goes down
}

TEST(KinematicTrajectory, AStraightRunNorthCoversTheMeridianArc) {
  // Vincenty: one minute of latitude from 45 deg north is 1852.2 m. Here the radius at its middle
  // is used.
  rig_config::MissionConfig mission;
  mission.latitude_rad = 45 * degree;
  mission.speed_mps = 2;
  const KinematicTrajectory trajectory(mission, start);
  const double minute = degree / 60;
  const double t = frame::meridian_radius(45 * degree + minute / 2) * minute / 2;
  EXPECT_NEAR((trajectory.at(at_s(t)).latitude_rad - 45 * degree) * 6.37e6, minute * 6.37e6, 1e-4);
}

TEST(KinematicTrajectory, RatesAndVelocityAreTheDerivativesOfAttitudeAndPosition) {
  const KinematicTrajectory trajectory(varied_mission(), start);
  const double h = 1e-2;
  for (double t = 0.5; t < 1300; t += 3.7) {
    const Truth before = trajectory.at(at_s(t - h));
    const Truth now = trajectory.at(at_s(t));
    const Truth after = trajectory.at(at_s(t + h));
    const Vector3d moved =
        frame::ned_offset({before.latitude_rad, before.longitude_rad, before.height_m},
                          {after.latitude_rad, after.longitude_rad, after.height_m});
    EXPECT_LT((moved / (2 * h) - now.velocity_ned).norm(), 1e-5) << "at " << t;
    const Eigen::AngleAxisd turned(before.body_to_ned.conjugate() * after.body_to_ned);
    EXPECT_LT((turned.angle() * turned.axis() / (2 * h) - now.rate_body).norm(), 1e-6) << t;
  }
}

TEST(KinematicTrajectory, AngularRateAndForceHaveNoStepsWhereLegsMeet) {
  const KinematicTrajectory trajectory(varied_mission(), start);
  for (const double knot : {0.0, 60.0, 150.0, 300.0, 450.0, 600.0, 660.0}) {
    const Truth before = trajectory.at(at_s(knot - 1e-4));
    const Truth after = trajectory.at(at_s(knot + 1e-4));
    EXPECT_LT((before.angular_rate - after.angular_rate).norm(), 1e-7) << knot;
    EXPECT_LT((before.specific_force - after.specific_force).norm(), 1e-6) << knot;
  }
}

RC_GTEST_PROP(KinematicTrajectory, AnswersTheSameInAnyOrder, ()) {
  const auto seconds = *rc::gen::container<std::vector<int>>(40, rc::gen::inRange(-10, 4000));
  const KinematicTrajectory one(varied_mission(), start);
  const KinematicTrajectory other(varied_mission(), start);
  std::vector<double> forward;
  for (const int t : seconds) forward.push_back(one.at(at_s(t + 0.25)).longitude_rad);
  for (std::size_t i = seconds.size(); i-- > 0;) {
    RC_ASSERT(other.at(at_s(seconds[i] + 0.25)).longitude_rad == forward[i]);
  }
}

TEST(KinematicTrajectory, ALapThatEndsAtItsDepthRepeatsTheMotion) {
  const KinematicTrajectory trajectory(varied_mission(), start);
  const Truth second = trajectory.at(at_s(600 + 200));
  const Truth third = trajectory.at(at_s(1200 + 200));
  EXPECT_NEAR(second.height_m, third.height_m, 1e-9);
  EXPECT_NEAR(second.pitch_rad, third.pitch_rad, 1e-12);
  EXPECT_NEAR(frame::wrap_pi(third.yaw_rad - second.yaw_rad), 150 * degree, 1e-9);
}

TEST(KinematicTrajectory, RefusesToTouchABedThatRisesUnderItsWay) {
  rig_config::MissionConfig mission;
  mission.latitude_rad = 47 * degree;
  mission.depth_m = 20;
  mission.speed_mps = 2;
  mission.legs = {{.kind = rig_config::LegKind::straight, .duration_s = 600, .speed_mps = 2}};
  mission.ocean.bed = {.kind = rig_config::BedKind::slope,
                       .depth_m = 60,
                       .gradient = 0.05,
                       .downhill_rad = 180 * degree,
                       .file = {}};
  try {
    KinematicTrajectory(mission, start);
    FAIL();
  } catch (const std::invalid_argument& refusal) {
    // 2 m/s up a slope of 1 in 20 from 40 m over the bed: 400 s.
    EXPECT_STREQ(refusal.what(),
                 "mission: after 400 s the vehicle would be 20.0 m deep, at or below the sea bed "
                 "(20.0 m there)");
  }
  mission.ocean.bed.downhill_rad = 90 * degree;
  const KinematicTrajectory along(mission, start);
  EXPECT_NEAR(along.at(at_s(600)).bed_depth_m, 60, 1e-6);
}

TEST(KinematicTrajectory, RefusesLegsThatCannotBeFlownAndSaysWhich) {
  rig_config::MissionConfig mission = varied_mission();
  mission.legs[2].duration_s = 10;
  try {
    const KinematicTrajectory trajectory(mission, start);
    FAIL() << "a dive of 40 m in 10 s at 2 m/s was accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("leg 3"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace drydock::motion
