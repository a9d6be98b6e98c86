#include <gtest/gtest.h>

#include "estimators/frame/earth.hpp"
#include "hil/motion/ordered/ordered_thrusters.hpp"
#include "hil/motion/ordered/ordered_trajectory.hpp"
#include "hil/motion/steered/steered_vehicle.hpp"
#include "rig_config/load.hpp"
#include "tests/hil/motion/mechanization.hpp"
#include "tests/hil/motion/missions.hpp"

namespace drydock::motion {
namespace {

/// The BlueROV2, 5 m deep, over a bed of 10 m.
struct RovOverBed {
  static constexpr double full = 120 * std::numbers::pi;  // 3600 r/min
  static constexpr int rear_starboard = 6, rear_port = 7, vertical_starboard = 8, vertical_port = 9;

  static rig_config::MissionConfig mission(double gradient) {
    auto mission =
        rig_config::load_mission(DRYDOCK_SOURCE_DIR "/rig_config/missions/thrusters.toml").value();
    mission.ocean.bed.kind = rig_config::BedKind::slope;
    mission.ocean.bed.depth_m = 10;
    mission.ocean.bed.gradient = gradient;
    mission.ocean.bed.downhill_rad = mission.heading_rad;
    return mission;
  }
  explicit RovOverBed(double gradient = 0) : motion(mission(gradient), start) {}
  void give(std::initializer_list<int> thrusters, double radps, double t) {
    for (const int thruster : thrusters) motion.orders()->give(thruster, radps, at_s(t));
  }
  Truth at(double t) const { return motion.at(at_s(t)); }

  OrderedThrusters motion;
};

rig_config::MissionConfig auv_over_bed(double depth_m, double bed_m) {
  rig_config::MissionConfig mission;
  mission.latitude_rad = 36 * degree;
  mission.depth_m = depth_m;
  mission.speed_mps = 1.5;
  mission.ocean.bed.depth_m = bed_m;
  mission.vehicle =
      rig_config::load_vehicle(DRYDOCK_SOURCE_DIR "/rig_config/vehicles/nps-auv-ii.toml").value();
  mission.steering = rig_config::SteeringConfig{.from = "wires"};
  return mission;
}

// A body at rest has the specific force -g, whatever pushes it.
TEST(Contact, AVehicleThatIsPressedOnTheBedFeelsOnlyGravity) {
  RovOverBed rov;
  for (const double share : {1.0, 0.5, 0.25}) {
    rov.give({rov.vertical_starboard, rov.vertical_port}, share * rov.full,
             share == 1 ? 0 : 8 / share);
    const Truth truth = rov.at(share == 1 ? 15 : 8 / share + 5);
    EXPECT_NEAR(-truth.height_m, 10, 1e-9) << share;
    EXPECT_NEAR(truth.velocity_ned.norm(), 0, 1e-9) << share;
    const double gravity = frame::gravity(truth.latitude_rad, truth.height_m);
    EXPECT_NEAR((truth.specific_force - Eigen::Vector3d{0, 0, -gravity}).norm(), 0, 1e-6) << share;
  }
}

// What an inertial navigation makes of the specific force ends where the vehicle is: the hit too is
// in it.
TEST(Contact, AnInertialNavigationPassesTheHitOnTheBed) {
  RovOverBed rov;
  rov.give({rov.vertical_starboard, rov.vertical_port}, rov.full, 0);
  const MechanizationError error = mechanize(rov.motion, start, 15, 0.0025);
  EXPECT_LT(error.velocity_mps, 1e-3);
  EXPECT_LT(error.position_m, 5e-3);
}

TEST(Contact, AnInertialNavigationPassesTheHitOnTheSurface) {
  OrderedTrajectory vehicle(auv_over_bed(5, 50), start);
  constexpr int stern_planes = 1;
  vehicle.orders()->give(stern_planes, -20 * degree, start);  // nose up
  const MechanizationError error = mechanize(vehicle, start, 90, 0.005);
  double highest = -5;
  for (int t = 0; t <= 90; ++t) highest = std::max(highest, vehicle.at(at_s(t)).height_m);
  EXPECT_NEAR(highest, 0.25, 0.01);
  EXPECT_LT(error.velocity_mps, 2e-3);
  EXPECT_LT(error.position_m, 0.1);
}

/// The largest difference of the specific force from R^T (dv/dt - g) on the way of the NPS AUV II,
/// whose planes push it down by this share of their limits, and how far it goes.
struct Comparison {
  double worst_mps2 = 0, height_m = 0;
};
Comparison compare_force_with_motion(double down) {
  const auto vehicle = make_steered_vehicle(auv_over_bed(3, 8));
  constexpr double h = 0.005;
  std::array<Truth, 3> path{vehicle->truth(), vehicle->truth(), vehicle->truth()};
  Comparison found;
  for (int i = 0; i < 60 / h; ++i) {
    vehicle->step(std::array{0.0, down, -down, 0.7}, h);  // rudder, planes, propeller
    path = {path[1], path[2], vehicle->truth()};
    const Eigen::Vector3d change = (path[2].velocity_ned - path[0].velocity_ned) / (2 * h);
    const Eigen::Vector3d gravity{0, 0, frame::gravity(path[1].latitude_rad, path[1].height_m)};
    const Eigen::Vector3d force = path[1].body_to_ned.conjugate() * (change - gravity);
    if (i > 2)
      found.worst_mps2 = std::max(found.worst_mps2, (force - path[1].specific_force).norm());
    found.height_m = down > 0 ? std::min(found.height_m, path[2].height_m)
                              : std::max(found.height_m, path[2].height_m);
  }
  return found;
}

// A difference over 10 ms rounds off the beginning of a push, and leaves out 2 w x V.
TEST(Contact, TheSpecificForceOfASteeredVehicleIsThatOfItsMotion) {
  const Comparison to_bed = compare_force_with_motion(0.2);
  EXPECT_NEAR(to_bed.height_m, -8, 0.01);
  EXPECT_LT(to_bed.worst_mps2, 0.3);
  const Comparison to_surface = compare_force_with_motion(-0.2);
  EXPECT_NEAR(to_surface.height_m, 0.25, 0.01);
  EXPECT_LT(to_surface.worst_mps2, 0.3);
}

TEST(Contact, AVehicleOnASlopeFollowsIt) {
  RovOverBed rov(0.1);
  rov.give({rov.vertical_starboard, rov.vertical_port}, rov.full, 0);
  rov.give({rov.rear_starboard, rov.rear_port}, rov.full / 2, 10);
  const Truth truth = rov.at(20);
  EXPECT_NEAR(-truth.height_m, truth.bed_depth_m, 0.002);
  EXPECT_GT(truth.velocity_ned.head<2>().norm(), 0.4);
  EXPECT_NEAR(truth.velocity_ned.z() / truth.velocity_ned.head<2>().norm(), 0.1, 1e-3);
}

// The vehicle file: buoyancy 2 N above its weight, damping 5.18 w + 36.99 w^2.
TEST(Contact, TheBedDoesNotHoldAVehicleThatRises) {
  RovOverBed rov;
  rov.give({rov.vertical_starboard, rov.vertical_port}, rov.full, 0);
  rov.give({rov.vertical_starboard, rov.vertical_port}, 0, 10);
  const double rise = (-5.18 + std::sqrt(5.18 * 5.18 + 4 * 36.99 * 2)) / (2 * 36.99);
  EXPECT_NEAR(rov.at(30).velocity_ned.z(), -rise, 1e-3);
}

}  // namespace
}  // namespace drydock::motion
