#include "hil/motion/ordered/ordered_trajectory.hpp"

#include <gtest/gtest.h>

#include "drivers/measurement/actuator_order.hpp"
#include "estimators/frame/attitude.hpp"
#include "hil/motion/make_trajectory.hpp"
#include "rig_config/kinematic_vehicle.hpp"
#include "rig_config/load.hpp"
#include "tests/hil/motion/missions.hpp"

namespace drydock::motion {
namespace {

void give(OrderSink& sink, const measurement::ActuatorOrder& order, Stamp at) {
  for (int actuator = 0; actuator < measurement::actuator_count; ++actuator)
    if (const auto& value = value_of(order, actuator)) sink.give(actuator, *value, at);
}

/// The NPS AUV II under way at 1500 rpm, 20 m deep.
rig_config::MissionConfig under_orders() {
  rig_config::MissionConfig mission;
  mission.latitude_rad = 36 * degree;
  mission.depth_m = 20;
  mission.speed_mps = 0.012 * 1500 * 2 * std::numbers::pi / 60;
  mission.vehicle =
      rig_config::load_vehicle(DRYDOCK_SOURCE_DIR "/rig_config/vehicles/nps-auv-ii.toml").value();
  mission.steering = rig_config::SteeringConfig{.from = "wires"};
  return mission;
}

struct Ordered {
  std::unique_ptr<Trajectory> motion = make_trajectory(under_orders(), start);
  void give(const measurement::ActuatorOrder& order, double t) {
    motion::give(*orders_of(*motion), order, at_s(t));
  }
};

// Lag 0.1 s, at most 2.5 deg/s: the lag asks for less than that from 0.25 deg before the target on,
// so the rudder is linear for 9.75 deg / 2.5 deg/s and then exponential.
TEST(OrderedTrajectory, ARudderFollowsItsOrderByRateThenByLag) {
  Ordered vehicle;
  vehicle.give({.rudder_rad = 10 * degree}, 1);
  for (const double t : {0.5, 1.0, 2.0, 3.37, 4.9})
    EXPECT_NEAR(vehicle.motion->at(at_s(t)).rudder_rad, std::max(t - 1, 0.0) * 2.5 * degree, 1e-12);
  for (const double t : {4.95, 5.0, 5.2})
    EXPECT_NEAR(vehicle.motion->at(at_s(t)).rudder_rad,
                (10 - 0.25 * std::exp(-(t - 4.9) / 0.1)) * degree, 1e-12);
}

TEST(OrderedTrajectory, APropellerFollowsItsOrderByItsLag) {
  Ordered vehicle;
  const double before = 1500 * 2 * std::numbers::pi / 60, ordered = 100;
  vehicle.give({.propeller_radps = ordered}, 2);
  EXPECT_NEAR(vehicle.motion->at(at_s(1.99)).propeller_radps, before, 1e-12);
  EXPECT_NEAR(vehicle.motion->at(at_s(2.25)).propeller_radps,
              ordered + (before - ordered) * std::exp(-2.5), 1e-9);
}

TEST(OrderedTrajectory, AnOrderBeyondTheStopEndsAtTheStop) {
  Ordered vehicle;
  vehicle.give({.rudder_rad = 3, .stern_plane_rad = -3, .propeller_radps = -50}, 0);
  const Truth truth = vehicle.motion->at(at_s(60));
  EXPECT_NEAR(truth.rudder_rad, 20 * degree, 1e-9);
  EXPECT_NEAR(truth.stern_plane_rad, -20 * degree, 1e-9);
  EXPECT_NEAR(truth.propeller_radps, 0, 1e-9);
}

// Healey and Lienard (1993): rudder 10 deg turns the vehicle on a circle of 29.4 m radius.
TEST(OrderedTrajectory, ARudderOfTenDegreesTurnsToPortOnThePublishedCircle) {
  Ordered vehicle;
  vehicle.give({.rudder_rad = 10 * degree}, 0);
  const Truth truth = vehicle.motion->at(at_s(300));
  const double rate_of_turn = truth.rate_body.z();
  EXPECT_LT(rate_of_turn, 0);
  EXPECT_NEAR(truth.velocity_ned.head<2>().norm() / std::abs(rate_of_turn), 29.4, 0.3);
}

TEST(OrderedTrajectory, AnOrderMovesNothingThatWasAskedForBefore) {
  Ordered vehicle;
  const Truth before = vehicle.motion->at(at_s(5));
  vehicle.give({.rudder_rad = 0.2}, 3);  // late
  EXPECT_EQ(vehicle.motion->at(at_s(5)).rudder_rad, before.rudder_rad);
  EXPECT_EQ(vehicle.motion->at(at_s(5)).specific_force, before.specific_force);
  EXPECT_GT(vehicle.motion->at(at_s(5.1)).rudder_rad, 0.08 * 2.5 * degree);
}

TEST(OrderedTrajectory, TheLastOrderReplacesThoseThatHaveNotBegun) {
  Ordered vehicle;
  vehicle.give({.rudder_rad = 0.2}, 8);
  vehicle.give({.stern_plane_rad = 0.1}, 2);
  vehicle.give({.rudder_rad = -0.1}, 4);
  EXPECT_EQ(vehicle.motion->at(at_s(3.9)).rudder_rad, 0);
  EXPECT_NEAR(vehicle.motion->at(at_s(20)).rudder_rad, -0.1, 1e-9);
  EXPECT_NEAR(vehicle.motion->at(at_s(20)).stern_plane_rad, 0.1, 1e-9);
}

TEST(OrderedTrajectory, AnyMomentCanBeAskedForAgainWithTheSameBits) {
  Ordered vehicle;
  std::vector<Truth> first;
  for (int i = 0; i < 200; ++i) {  // several blocks of 10.24 s
    vehicle.give({.rudder_rad = 0.1 * std::sin(0.3 * i), .stern_plane_rad = 0.02 * (i % 5)}, i);
    first.push_back(vehicle.motion->at(at_s(i + 0.7)));
  }
  for (int i = 0; i < 200; i += 37) {
    const Truth again = vehicle.motion->at(at_s(i + 0.7));
    const Truth& once = first[static_cast<std::size_t>(i)];
    EXPECT_EQ(again.latitude_rad, once.latitude_rad);
    EXPECT_EQ(again.rudder_rad, once.rudder_rad);
    EXPECT_EQ(again.specific_force, once.specific_force);
  }
}

TEST(OrderedTrajectory, AVehicleUnderOrdersStaysInTheWater) {
  Ordered vehicle;
  vehicle.give({.stern_plane_rad = -20 * degree}, 0);  // nose up
  for (int t = 0; t < 120; ++t) EXPECT_LE(vehicle.motion->at(at_s(t)).height_m, 0.25 + 1e-9);
  vehicle.give({.stern_plane_rad = 20 * degree}, 120);
  for (int t = 120; t < 400; ++t)
    EXPECT_LE(-vehicle.motion->at(at_s(t)).height_m,
              vehicle.motion->at(at_s(t)).bed_depth_m + 1e-6);
}

// The actuator law of the kinematic vehicle: 0.012 m/rad, and a circle of 29.4 m at rudder 10 deg;
// its speed follows two lags, of 0.1 s and 0.5 s.
TEST(OrderedTrajectory, AVehicleWithoutAHullFollowsItsActuators) {
  auto mission = under_orders();
  mission.vehicle = rig_config::kinematic_vehicle();
  const OrderedTrajectory motion(mission, start);
  const double before = mission.speed_mps, ordered = 0.012 * 100;
  give(*motion.orders(), {.rudder_rad = 10 * degree, .propeller_radps = 100}, start);
  const auto speed = [&](double t) { return motion.at(at_s(t)).velocity_body.x(); };
  const double t = 0.8, both = (0.5 * std::exp(-t / 0.5) - 0.1 * std::exp(-t / 0.1)) / 0.4;
  EXPECT_NEAR(speed(t + 0.01), ordered + (before - ordered) * both, 1e-6);  // one cycle later
  const Truth truth = motion.at(at_s(60));
  EXPECT_NEAR(truth.velocity_body.x(), 1.2, 1e-6);
  EXPECT_NEAR(truth.velocity_ned.norm() / -truth.rate_body.z(), 29.4, 1e-3);
  EXPECT_NEAR(truth.roll_rad, 0, 1e-9);
  give(*motion.orders(),
       {.rudder_rad = 0, .stern_plane_rad = 2 * degree, .bow_plane_rad = -2 * degree}, at_s(60));
  EXPECT_NEAR(motion.at(at_s(70)).rate_body.y(), -1.2 * 2 * degree / (10 * degree * 29.4), 1e-5);
}

TEST(OrderedTrajectory, NobodyOrdersAMotionThatFollowsItsLegs) {
  const KinematicTrajectory motion(varied_mission(), start);
  EXPECT_EQ(orders_of(motion), nullptr);
}

}  // namespace
}  // namespace drydock::motion
