#include "hil/motion/waypoint_guidance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "estimators/frame/geodetic.hpp"
#include "hil/motion/bad_mission.hpp"
#include "hil/motion/vehicle/vehicle_trajectory.hpp"
#include "rig_config/load.hpp"
#include "tests/hil/motion/missions.hpp"

namespace drydock::motion {
namespace {

using Eigen::Vector2d;

rig_config::MissionConfig mission_to(std::vector<rig_config::WaypointConfig> waypoints,
                                     double lookahead_m = 12) {
  rig_config::MissionConfig mission;
  mission.latitude_rad = 36 * degree;
  mission.depth_m = 20;
  mission.speed_mps = 1.8;
  mission.vehicle =
      rig_config::load_vehicle(DRYDOCK_SOURCE_DIR "/rig_config/vehicles/nps-auv-ii.toml").value();
  mission.waypoints = std::move(waypoints);
  mission.guidance.lookahead_m = lookahead_m;
  return mission;
}

rig_config::WaypointConfig at(double north_m, double east_m, double depth_m = 20) {
  return {.north_m = north_m, .east_m = east_m, .depth_m = depth_m, .speed_mps = 1.8};
}

/// A point that moves with speed 2 m/s where the guidance wants it, in a current.
struct Point {
  WaypointGuidance guidance;
  Vector2d place;
  Vector2d current = Vector2d::Zero();
  GuidanceMemory memory{};

  static constexpr double speed_mps = 2, dt = 0.001;

  void sail(double seconds) {
    for (int i = 0; i < std::lround(seconds / dt); ++i) {
      guidance.pass(place, memory);
      const double heading = guidance.wanted(place, memory, dt).yaw.value;
      place += dt * (speed_mps * Vector2d(std::cos(heading), std::sin(heading)) + current);
    }
  }
};

Point beside_the_line(double cross_m, double integral_gain_mps = 0) {
  auto mission = mission_to({at(0, 0), at(4000, 0)});
  mission.guidance.integral_gain_mps = integral_gain_mps;
  return {WaypointGuidance(mission), {0, cross_m}};
}

TEST(TrackErrors, AreTheSidesOfARightAngle) {
  // A line to the north-east; (3, 1) is 4/sqrt(2) along it and 2/sqrt(2) to port.
  const auto errors = track_errors({0, 0}, {5, 5}, {3, 1});
  EXPECT_NEAR(errors.along, 4 / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(errors.cross, -2 / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(track_errors({1, 2}, {1, -7}, {-2, 0}).cross, -3, 1e-12) << "a course west";
}

// Near the line the sine of the angle to it is -e/D, so e falls as exp(-U t / D).
TEST(WaypointGuidance, ASmallCrossTrackErrorFallsExponentially) {
  for (const double cross_m : {0.05, -0.05}) {
    Point point = beside_the_line(cross_m);
    point.sail(15);
    EXPECT_NEAR(point.place.y(), cross_m * std::exp(-2.0 * 15 / 12), 1e-6);
  }
}

// de/dt = -U e / sqrt(e^2 + D^2) has the integral f(e) = sqrt(e^2 + D^2) - D asinh(D / |e|), which
// falls by U t: the curve of a tractrix.
TEST(WaypointGuidance, ALargeCrossTrackErrorFallsAsTheLawIntegrates) {
  const auto f = [](double e) { return std::hypot(e, 12) - 12 * std::asinh(12 / e); };
  Point point = beside_the_line(60);
  for (int i = 1; i <= 4; ++i) {
    point.sail(12);
    EXPECT_NEAR(f(60) - f(point.place.y()), 2.0 * 12 * i, 0.01);
  }
}

// Across a current V the law rests where U e / sqrt(e^2 + D^2) = V.
TEST(WaypointGuidance, ACurrentLeavesTheErrorAtWhichTheSpeedAcrossIsItsOwn) {
  Point point = beside_the_line(0);
  point.current = {0, 0.5};
  point.sail(200);
  EXPECT_NEAR(point.place.y(), 12 * 0.5 / std::sqrt(2.0 * 2 - 0.5 * 0.5), 1e-4);
}

// With an integral the vehicle rests on the line, and gain times integral is that error.
TEST(WaypointGuidance, TheIntegralTakesTheErrorOfACurrentOff) {
  Point point = beside_the_line(0, 0.3);
  point.current = {0, 0.5};
  point.sail(1500);
  EXPECT_NEAR(point.place.y(), 0, 1e-3);
  EXPECT_NEAR(0.3 * point.memory.integral_s, 12 * 0.5 / std::sqrt(2.0 * 2 - 0.5 * 0.5), 1e-3);
}

TEST(WaypointGuidance, OnTheLineTheHeadingIsThatOfTheLine) {
  const WaypointGuidance guidance(mission_to({at(10, 10), at(110, 110, 30)}));
  GuidanceMemory memory;
  const Prescribed wanted = guidance.wanted({60, 60}, memory, 0.01);
  EXPECT_NEAR(wanted.yaw.value, 45 * degree, 1e-12);
  EXPECT_NEAR(wanted.depth_m, 25, 1e-12) << "half of the way down";
  EXPECT_NEAR(wanted.descent_mps, 1.8 * 10 / (100 * std::sqrt(2.0)), 1e-12);
  EXPECT_NEAR(guidance.wanted({210, 210}, memory, 0.01).depth_m, 30, 1e-12) << "behind the line";
}

// The rate is the derivative of the heading along the course that the law asks for.
TEST(WaypointGuidance, TheRateOfTurnIsTheDerivativeOfTheHeading) {
  const WaypointGuidance guidance(mission_to({at(0, 0), at(1000, 0)}));
  GuidanceMemory memory;
  const auto heading = [&](double cross_m) {
    return guidance.wanted({0, cross_m}, memory, 0.01).yaw.value;
  };
  for (const double cross_m : {-30.0, -4.0, 0.0, 9.0}) {
    const double across_mps = 1.8 * std::sin(heading(cross_m)), h = 1e-3;
    const double slope = (heading(cross_m + h) - heading(cross_m - h)) / (2 * h);
    EXPECT_NEAR(guidance.wanted({0, cross_m}, memory, 0.01).yaw.rate, slope * across_mps, 1e-8);
  }
}

// Coming along the first line the circle of radius 10 m is met 10 m before the corner.
TEST(WaypointGuidance, TheLineChangesOnTheCircleOfAcceptance) {
  auto mission = mission_to({at(0, 0), at(100, 0), at(100, 100)});
  mission.waypoints[1].radius_m = 10;
  const WaypointGuidance guidance(mission);
  GuidanceMemory memory;
  EXPECT_FALSE(guidance.pass({89.999, 0}, memory));
  EXPECT_EQ(memory.line, 0);
  const auto passed = guidance.pass({90, 0}, memory);
  ASSERT_TRUE(passed);
  EXPECT_TRUE(passed->reached);
  EXPECT_EQ(passed->waypoint, 1);
  EXPECT_EQ(passed->off_m, 10);
  EXPECT_EQ(memory.line, 1);
  EXPECT_NEAR(guidance.wanted({100, 40}, memory, 0.01).yaw.value, 90 * degree, 1e-12);
}

TEST(WaypointGuidance, AWaypointThatIsPassedOutsideItsCircleIsMissed) {
  auto mission = mission_to({at(0, 0), at(100, 0), at(200, 0)});
  mission.waypoints[1].radius_m = 10;
  const WaypointGuidance guidance(mission);
  GuidanceMemory memory;
  EXPECT_FALSE(guidance.pass({99.9, 11}, memory));
  const auto passed = guidance.pass({100, 11}, memory);
  ASSERT_TRUE(passed);
  EXPECT_FALSE(passed->reached);
  EXPECT_EQ(passed->off_m, 11);
}

TEST(WaypointGuidance, BehindTheLastWaypointTheLastLineGoesOn) {
  const WaypointGuidance guidance(mission_to({at(0, 0), at(100, 0)}));
  GuidanceMemory memory;
  ASSERT_TRUE(guidance.pass({100, 0}, memory));
  EXPECT_TRUE(memory.over);
  EXPECT_FALSE(guidance.pass({100, 0}, memory)) << "said once";
  const Prescribed wanted = guidance.wanted({500, 0}, memory, 0.01);
  EXPECT_NEAR(wanted.yaw.value, 0, 1e-12);
  EXPECT_EQ(wanted.speed.value, 1.8);
  EXPECT_EQ(wanted.descent_mps, 0);
}

TEST(WaypointGuidance, TheCircleIsTwoLengthsOfTheVehicleAndTheLookAheadFour) {
  const WaypointGuidance guidance(mission_to({at(0, 0), at(100, 0)}, 0));
  EXPECT_NEAR(guidance.waypoints()[1].radius_m, 10.6, 0.02);
  GuidanceMemory memory;
  EXPECT_NEAR(guidance.wanted({0, 21.2}, memory, 0.01).yaw.value, -45 * degree, 1e-3);
}

std::string refusal(const rig_config::MissionConfig& mission) {
  try {
    const VehicleTrajectory motion(mission, start);
  } catch (const BadMission& error) {
    return error.path + ": " + error.what();
  }
  return "accepted";
}

TEST(WaypointGuidance, LinesThatCannotBeSailedAreRefused) {
  EXPECT_EQ(refusal(mission_to({at(0, 0)})), "/waypoint: mission: a line needs two waypoints");
  EXPECT_EQ(refusal(mission_to({at(0, 0), at(5, 0), at(5, 0)})),
            "/waypoint/2: mission waypoint 3: it is at the place of the one before it");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(refusal(mission_to({at(0, 0), at(nan, 0)})), "accepted");
  EXPECT_EQ(refusal(mission_to({at(0, 0), at(10, 0, 40)})),
            "/waypoint/1/depth_m: mission waypoint 2: its line is steeper than 30 deg; allow a "
            "longer way or less change of depth");
  EXPECT_EQ(refusal(mission_to({at(0, 0), at(500, 0, 150)})),
            "/waypoint/1: mission waypoint 2: its line leads 100.2 m deep, at or below the sea bed "
            "(100.0 m there)");
  auto fast = mission_to({at(0, 0), at(500, 0)});
  fast.waypoints[1].speed_mps = 20;
  EXPECT_EQ(refusal(fast).find("/waypoint/1: mission waypoint 2: the vehicle would need 20.00 m/s"),
            0);
}

/// The place of the vehicle, m north and east of where its mission begins.
Vector2d place_at(const VehicleTrajectory& motion, double t) {
  const Truth first = motion.at(start), now = motion.at(at_s(t));
  return frame::ned_offset({first.latitude_rad, first.longitude_rad, first.height_m},
                           {now.latitude_rad, now.longitude_rad, now.height_m})
      .head<2>();
}

// The vehicle has inertia, so it converges later than the law alone; then it is on the line.
TEST(WaypointGuidance, TheVehicleComesOntoItsLinesAndTurnsAtTheCircle) {
  const VehicleTrajectory motion(mission_to({at(0, 8), at(300, 8), at(300, 300)}, 20), start);
  EXPECT_NEAR(place_at(motion, 120).y(), 8, 0.05);
  EXPECT_NEAR(motion.at(at_s(120)).yaw_rad, 0, 0.01);
  EXPECT_NEAR(place_at(motion, 290).x(), 300, 0.1);
  EXPECT_NEAR(motion.at(at_s(290)).yaw_rad, 90 * degree, 0.01);
  EXPECT_NEAR(measurement::seconds(motion.end() - start), (300 + 292) / 1.8, 1e-6);
}

TEST(WaypointGuidance, AnyMomentCanBeAskedForAgainWithTheSameBits) {
  const VehicleTrajectory motion(mission_to({at(0, 8), at(60, 8), at(60, 90)}), start);
  const Truth late = motion.at(at_s(75));
  motion.at(at_s(3));
  const VehicleTrajectory again(mission_to({at(0, 8), at(60, 8), at(60, 90)}), start);
  for (int t = 0; t <= 75; ++t) again.at(at_s(t));
  EXPECT_EQ(again.at(at_s(75)).longitude_rad, late.longitude_rad);
  EXPECT_EQ(motion.at(at_s(75)).specific_force, late.specific_force);
}

}  // namespace
}  // namespace drydock::motion
