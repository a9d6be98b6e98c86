#include "hil/steer/joint_helm.hpp"

#include <gmock/gmock.h>

#include "hil/motion/steered/steered_trajectory.hpp"
#include "tests/hil/steer/json_autopilot.hpp"

namespace drydock::steer::test {
namespace {

using measurement::BodyWrench;
using measurement::JointOrder;
using testing::Contains;
using testing::Each;
using testing::HasSubstr;

rig_config::MissionConfig for_dds(const std::string& vehicle) {
  auto mission = mission_of(vehicle);
  mission.steering->from = "dds";
  return mission;
}

/// A helm and the vehicle that it steers, in virtual time.
struct Steered {
  explicit Steered(const std::string& vehicle)
      : mission(for_dds(vehicle)),
        helm(mission, [this](const std::string& line) { said.push_back(line); }),
        motion(mission, bench_s(0)) {}

  void order(const std::string& joint, std::optional<double> position,
             std::optional<double> velocity = {}, std::optional<double> effort = {}) {
    const JointOrder one{joint, position, velocity, effort};
    helm.order(std::span(&one, 1), bench_s(now_s));
  }
  /// Runs for a time; `again` gives the orders anew ten times a second.
  template <class Again>
  motion::Truth run(double seconds, Again again) {
    for (int i = 0; i < std::lround(seconds * 100); ++i) {
      if (i % 10 == 0) again();
      now_s += 0.01;
      const auto outputs = helm.outputs(bench_s(now_s), motion.latest());
      motion.step(outputs, 0.01, bench_s(now_s));
    }
    return motion.latest();
  }
  std::vector<double> outputs() {
    const auto all = helm.outputs(bench_s(now_s), motion.latest());
    return {all.begin(), all.end()};
  }

  rig_config::MissionConfig mission;
  std::vector<std::string> said;
  JointHelm helm;
  motion::SteeredTrajectory motion;
  double now_s = 0;
};

// This vehicle's file: the rudder turns by 2.5 degrees a second, to 20 degrees at most.
TEST(JointHelm, ASurfaceGoesToTheAngleOfItsOrderAtItsRateAndNotBeyondItsStop) {
  Steered rig("nps-auv-ii.toml");
  const auto held = rig.run(5, [&] { rig.order("rudder", 0.1); });
  EXPECT_NEAR(held.rudder_rad, 0.1, 1e-4);
  EXPECT_EQ(held.stern_plane_rad, 0);
  EXPECT_EQ(rig.helm.counters().limited, 0u);
  const auto hard_over = [&] { rig.order("rudder", -2); };
  EXPECT_NEAR(rig.run(5, hard_over).rudder_rad, 0.1 - 5 * 2.5 * degree, 1e-3);
  EXPECT_NEAR(rig.run(10, hard_over).rudder_rad, -20 * degree, 1e-4);
  EXPECT_EQ(rig.helm.counters().limited, 150u);
}

TEST(JointHelm, APropellerTurnsAsOrderedAndDoesNotTurnAstern) {
  Steered rig("nps-auv-ii.toml");
  EXPECT_NEAR(rig.run(20, [&] { rig.order("propeller", {}, 120); }).propeller_radps, 120, 0.05);
  EXPECT_NEAR(rig.run(20, [&] { rig.order("propeller", {}, -50); }).propeller_radps, 0, 0.05);
}

TEST(JointHelm, AJointWithoutAnOrderForASecondGoesToItsSafeState) {
  Steered rig("nps-auv-ii.toml");
  rig.run(10, [&] {
    rig.order("rudder", 0.2);
    rig.order("propeller", {}, 120);
  });
  const auto nobody = [] {};
  EXPECT_GT(rig.run(0.8, nobody).rudder_rad, 0.19);
  const auto safe = rig.run(20, nobody);
  EXPECT_NEAR(safe.rudder_rad, 0, 1e-4);
  EXPECT_NEAR(safe.propeller_radps, 0, 0.05);
  EXPECT_EQ(rig.helm.counters().timeouts, 2u);
  EXPECT_THAT(rig.said, Contains(HasSubstr("rudder")));
}

// Closed form of the steady state as in autopilot_session_test.cpp: four thrusters at 45 degrees
// push with 20 N each, and damping of 4.03 u + 18.18 u^2 equals that.
TEST(JointHelm, AThrusterPushesWithTheNewtonsOfItsOrder) {
  Steered rig("bluerov2.toml");
  const auto moved = rig.run(15, [&] {
    for (const char* front : {"front-starboard", "front-port"}) rig.order(front, {}, {}, -20.0);
    for (const char* rear : {"rear-starboard", "rear-port"}) rig.order(rear, {}, {}, 20.0);
  });
  const double push = 4 * 20 / std::sqrt(2.0);
  const double u = (-4.03 + std::sqrt(4.03 * 4.03 + 4 * 18.18 * push)) / (2 * 18.18);
  EXPECT_NEAR(moved.velocity_ned.head<2>().norm(), u, 0.02 * u);
}

TEST(JointHelm, AWrenchMovesTheBodyAsOneForceOfItsSize) {
  Steered ahead("bluerov2.toml"), down("bluerov2.toml"), turning("bluerov2.toml");
  const auto hold = [](Steered& rig, const BodyWrench& wrench) {
    return rig.run(15, [&] { rig.helm.order(wrench, bench_s(rig.now_s)); });
  };
  const auto speed = [](double push, double linear, double quadratic) {
    return (-linear + std::sqrt(linear * linear + 4 * quadratic * push)) / (2 * quadratic);
  };
  const double u = speed(40, 4.03, 18.18);
  EXPECT_NEAR(hold(ahead, {{40, 0, 0}, {0, 0, 0}}).velocity_ned.y(), u, 0.02 * u) << "heading east";
  EXPECT_NEAR(hold(down, {{0, 0, 30}, {0, 0, 0}}).velocity_ned.z(), speed(30 - 2, 5.18, 36.99),
              0.005);
  const double r = speed(3, 0.07, 1.55);
  EXPECT_NEAR(hold(turning, {{0, 0, 0}, {0, 0, 3}}).rate_body.z(), r, 0.02 * r);
}

TEST(ThrustAllocation, ThePushesAddUpToWhatTheThrustersCanGive) {
  std::vector<motion::Thruster> thrusters;
  const auto mission = mission_of("bluerov2.toml");
  for (const auto& config : mission.thruster_vehicle->thrusters) thrusters.emplace_back(config);
  const ThrustAllocation allocation(thrusters);
  const auto sum = [&](const BodyWrench& wrench) {
    const auto pushes = allocation.pushes(wrench);
    hydrodynamics::Wrench all = hydrodynamics::Wrench::Zero();
    for (std::size_t i = 0; i < pushes.size(); ++i) {
      EXPECT_LE(std::abs(pushes[i]), thrusters[i].limit_n(pushes[i]) + 1e-9);
      all += pushes[i] * thrusters[i].of_one_newton();
    }
    return all;
  };
  hydrodynamics::Wrench wanted;
  wanted << 12, -7, 20, 0.4, 0, -1.5;  // it cannot pitch
  EXPECT_LT((sum({wanted.head<3>(), wanted.tail<3>()}) - wanted).norm(), 1e-9);
  // Four thrusters astern or ahead at 45 degrees: two push at most 40.2 N.
  const auto beyond = sum({{1000, 0, 0}, {0, 0, 0}});
  EXPECT_NEAR(beyond[0], 4 * 40.2 / std::sqrt(2.0), 0.01);
  EXPECT_LT(beyond.tail<5>().norm(), 0.01);
}

TEST(Thruster, TheCommandForAPushGivesThatPush) {
  const motion::Thruster thruster(mission_of("bluerov2.toml").thruster_vehicle->thrusters[0]);
  for (const double push : {-40.2, -13.0, -0.01, 0.0, 0.01, 7.5, 51.5})
    EXPECT_NEAR(thruster.steady_push_n(thruster.command_for(push)), push, 1e-9);
  EXPECT_EQ(thruster.command_for(1000), 1);
}

TEST(JointHelm, AnOrderThatNoJointObeysIsToldOnceWithWhatIsAllowed) {
  Steered fins("nps-auv-ii.toml"), rov("bluerov2.toml");
  for (int i = 0; i < 3; ++i) fins.order("aileron", 0.1);
  fins.order("rudder", {}, 3.0);
  fins.helm.order(BodyWrench{{1, 0, 0}, {0, 0, 0}}, bench_s(0));
  ASSERT_EQ(fins.said.size(), 3u);
  EXPECT_THAT(fins.said[0], HasSubstr("allowed: rudder, stern_planes, bow_planes, propeller"));
  EXPECT_THAT(fins.said[1], HasSubstr("rudder without a value, it obeys a position in rad"));
  EXPECT_THAT(fins.said[2], HasSubstr("a vehicle with thrusters"));
  EXPECT_EQ(fins.helm.counters().refused, 5u);
  EXPECT_THAT(fins.outputs(), Each(0.0));
  rov.order("rear-port", 0.3);
  EXPECT_THAT(rov.said, Contains(HasSubstr("an effort in N")));
}

TEST(JointHelm, ASurfaceThatSticksOnItsWayStandsThere) {
  Steered rig("nps-auv-ii.toml");
  const auto hard_over = [&] { rig.order("rudder", 0.3); };
  const double there = rig.run(3, hard_over).rudder_rad;
  EXPECT_NEAR(there, 3 * 2.5 * degree, 0.01);
  rig.helm.set_troubles({{"rudder", {.stuck = true}}});
  EXPECT_NEAR(rig.run(20, hard_over).rudder_rad, there, 1e-3);
}

TEST(JointHelm, AStuckSurfaceStandsALostPropellerStopsALateRudderWaits) {
  Steered rig("nps-auv-ii.toml");
  const auto orders = [&](double rudder, double planes) {
    rig.order("rudder", rudder);
    rig.order("stern_planes", planes);
    rig.order("propeller", {}, 120);
  };
  rig.run(20, [&] { orders(0.1, 0.1); });
  rig.helm.set_troubles({{"stern_planes", {.stuck = true}},
                         {"propeller", {.powerless = true}},
                         {"rudder", {.late = std::chrono::seconds{2}}}});
  const auto first = rig.run(2, [&] { orders(0.1, -0.1); });
  EXPECT_NEAR(first.stern_plane_rad, 0.1, 1e-4);
  EXPECT_LT(first.propeller_radps, 60);
  // The last order before the fault counts for 1 s, the next one comes 2 s after the fault: for a
  // second the rudder goes amidships.
  EXPECT_NEAR(first.rudder_rad, 0.1 - 2.5 * degree, 0.005);
  EXPECT_NEAR(rig.run(10, [&] { orders(0.1, -0.1); }).rudder_rad, 0.1, 1e-3);
  rig.helm.set_troubles({});
  EXPECT_NEAR(rig.run(20, [&] { orders(-0.1, -0.1); }).stern_plane_rad, -0.1, 1e-3);
}

// The law of a kinematic vehicle: 10 degrees of rudder turn it on a radius of 29.4 m, and its
// propeller gives 0.012 m for each radian.
TEST(JointHelm, AKinematicVehicleTurnsAndSailsByTheLawOfItsActuators) {
  Steered rig({});
  const auto moved = rig.run(40, [&] {
    rig.order("rudder", -10 * degree);
    rig.order("propeller", {}, 150);
  });
  EXPECT_NEAR(moved.velocity_ned.norm(), 1.8, 0.01);
  EXPECT_NEAR(moved.rate_body.z(), 1.8 / 29.4, 1e-3) << "to starboard";
}

}  // namespace
}  // namespace drydock::steer::test
