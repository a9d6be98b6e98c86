#include <gtest/gtest.h>

#include <cmath>

#include "estimators/frame/geodetic.hpp"
#include "rig_config/load.hpp"
#include "tests/hil/motion/mechanization.hpp"
#include "tests/hil/motion/missions.hpp"

/// Legs with ramps, side slip, and the 600 s run of the fuzzy mixing paper that needs both.
namespace drydock::motion::mixing_mission_test {
namespace {

using Eigen::Vector3d;
using rig_config::LegKind;

class MixingMission : public testing::Test {
 protected:
  const rig_config::MissionConfig mission_ =
      rig_config::load_mission(DRYDOCK_SOURCE_DIR "/rig_config/missions/mixing-paper.toml").value();
  const KinematicTrajectory trajectory_{mission_, start};

  Truth at(double t) const { return trajectory_.at(at_s(t)); }
};

TEST_F(MixingMission, EndsAtThePapersPoint) {
  const Truth begin = at(0), end = at(600);
  EXPECT_EQ(trajectory_.end(), at_s(600));
  EXPECT_EQ(begin.height_m, 0);
  const Vector3d offset = frame::ned_offset({begin.latitude_rad, begin.longitude_rad, 0},
                                            {end.latitude_rad, end.longitude_rad, end.height_m});
  EXPECT_NEAR(offset.x(), 1454, 0.1);
  EXPECT_NEAR(offset.y(), 11'232, 0.1);
  EXPECT_NEAR(-end.height_m, 2.7, 0.01);
}

TEST_F(MixingMission, EndsThereOnAFlatChartToo) {
  Vector3d sum = Vector3d::Zero();
  for (double t = 0.05; t < 600; t += 0.1) sum += 0.1 * at(t).velocity_ned;
  EXPECT_NEAR(sum.x(), 1454, 0.1);
  EXPECT_NEAR(sum.y(), 11'232, 0.1);
  EXPECT_NEAR(sum.z(), 2.7, 0.01);
}

TEST_F(MixingMission, DoesWhatThePaperTellsOfIt) {
  for (const double t : {45.0, 70.0, 100.0, 300.0, 569.0}) EXPECT_NEAR(-at(t).height_m, 40, 1.5);
  EXPECT_NEAR(std::abs(at(72.5).yaw_rad), degree * 180, 1e-9);  // half a circle
  EXPECT_NEAR(at(134).velocity_body.x(), 6, 1e-9);
  EXPECT_GT(at(156).velocity_body.x(), 26);
  EXPECT_GT(at(590).pitch_rad, 0);
}

TEST_F(MixingMission, AnIndependentMechanizationOfItsImuFindsItAgain) {
  const MechanizationError error = mechanize(trajectory_, start, 600, 0.05);
  EXPECT_LT(error.position_m, 0.05);
  EXPECT_LT(error.velocity_mps, 5e-4);
  EXPECT_LT(error.attitude_rad, 1e-6);
}

TEST_F(MixingMission, ASteadyTurnSlipsAboutThePivot) {
  const Truth circling = at(80);
  const Vector3d pivot{2.5, 0, 0};
  const Vector3d there = circling.velocity_body + circling.rate_body.cross(pivot);
  EXPECT_NEAR(circling.rate_body.z(), 360 * degree / 50 * std::cos(5 * degree), 1e-12);
  EXPECT_NEAR(there.y(), 0, 1e-9);
  EXPECT_NEAR(there.z(), 0, 1e-9);
}

TEST_F(MixingMission, SlipFollowsTheTurnThroughTwoLags) {
  // After two lags of 0.5 s, the middle of a slow ramp is 1 s late.
  const double middle = 45 + 2.5, full = at(80).velocity_body.y();
  EXPECT_NEAR(at(middle + 1).velocity_body.y() / full, 0.5, 0.02);
  EXPECT_LT(at(middle).velocity_body.y() / full, 0.25);
}

TEST_F(MixingMission, RatesAndVelocityAreTheDerivativesOfAttitudeAndPosition) {
  const double h = 1e-2;
  for (double t = 0.5; t < 600; t += 1.7) {
    const Truth before = at(t - h), now = at(t), after = at(t + h);
    const Vector3d moved =
        frame::ned_offset({before.latitude_rad, before.longitude_rad, before.height_m},
                          {after.latitude_rad, after.longitude_rad, after.height_m});
    EXPECT_LT((moved / (2 * h) - now.velocity_ned).norm(), 2e-4)
        << "at " << t;  // over 20 ms, with a jerk of 8 m/s3
    const Vector3d change = (after.velocity_body - before.velocity_body) / (2 * h);
    const Vector3d felt = now.body_to_ned.conjugate() * Vector3d{0, 0, 9.78} + now.specific_force -
                          now.rate_body.cross(now.velocity_body);
    EXPECT_LT((change - felt).norm(), 0.01) << "at " << t;  // without Coriolis, 4e-3 m/s2
  }
}

TEST_F(MixingMission, ForceAndRateHaveNoStepsWhereLegsMeet) {
  for (const double knot : {4.0, 40.0, 45.0, 100.0, 135.0, 155.0, 165.0, 200.0, 570.0, 598.0}) {
    const Truth before = at(knot - 1e-4), after = at(knot + 1e-4);
    EXPECT_LT((before.angular_rate - after.angular_rate).norm(), 1e-7) << knot;
    EXPECT_LT((before.specific_force - after.specific_force).norm(), 2e-5) << knot;
  }
}

TEST(RampedLegs, AccelerationTurnAndSinkAreConstantBetweenTheRamps) {
  rig_config::MissionConfig mission;
  mission.depth_m = 10;
  mission.speed_mps = 2;
  mission.legs = {
      {.kind = LegKind::straight, .duration_s = 12, .speed_mps = 7, .ramp_s = 2},
      {.kind = LegKind::turn, .duration_s = 60, .turn_rad = 1, .speed_mps = 7, .ramp_s = 20},
      {.kind = LegKind::dive,
       .duration_s = 50,
       .depth_change_m = 40,
       .speed_mps = 7,
       .ramp_s = 10}};
  const KinematicTrajectory trajectory(mission, start);
  for (const double t : {2.5, 6.0, 9.5}) {  // 5 m/s in 12 s minus one ramp
    EXPECT_NEAR(trajectory.at(at_s(t + 0.5)).velocity_body.x() -
                    trajectory.at(at_s(t - 0.5)).velocity_body.x(),
                0.5, 1e-12);
  }
  for (const double t : {33.0, 42.0, 51.0}) {
    EXPECT_NEAR(trajectory.at(at_s(t)).rate_body.z(), 1.0 / 40, 1e-12);
  }
  for (const double t : {83.0, 97.0, 111.0}) {
    EXPECT_NEAR(trajectory.at(at_s(t)).velocity_ned.z(), 1, 1e-12);
  }
  EXPECT_NEAR(trajectory.at(at_s(122)).height_m, -50, 1e-9);
}

TEST(RampedLegs, TwoRampsMustFitIntoTheLeg) {
  rig_config::MissionConfig mission;
  mission.legs = {{.kind = LegKind::straight, .duration_s = 3, .ramp_s = 1.6}};
  EXPECT_THROW(KinematicTrajectory(mission, start), std::invalid_argument);
}

}  // namespace
}  // namespace drydock::motion::mixing_mission_test
