#include "hil/motion/ordered/ordered_thrusters.hpp"

#include <gtest/gtest.h>

#include "hil/motion/make_trajectory.hpp"
#include "rig_config/load.hpp"
#include "tests/hil/motion/missions.hpp"

namespace drydock::motion {
namespace {

// The vehicle file: 3600 r/min at full command, 51.5 N ahead and 40.2 N astern, exponent 1.5, no
// push within 7 % of the command, lag 0.1 s; weight 112.8 N, buoyancy 114.8 N.
constexpr double full = 120 * std::numbers::pi;
constexpr int rear_starboard = 6, rear_port = 7, vertical_starboard = 8, vertical_port = 9;

struct Rov {
  std::unique_ptr<Trajectory> motion = make_trajectory(
      rig_config::load_mission(DRYDOCK_SOURCE_DIR "/rig_config/missions/thrusters.toml").value(),
      start);
  void give(int thruster, double radps, double t) {
    orders_of(*motion)->give(thruster, radps, at_s(t));
  }
  Truth at(double t) const { return motion->at(at_s(t)); }
};

double push_n(double share, double most_n) { return most_n * std::pow((share - 0.07) / 0.93, 1.5); }

/// The speed at which damping l v + q v^2 takes up a force.
double speed(double force_n, double l, double q) {
  return (-l + std::sqrt(l * l + 4 * q * force_n)) / (2 * q);
}

TEST(OrderedThrusters, AVehicleThatIsLeftAloneRisesByItsBuoyancy) {
  const Rov rov;
  EXPECT_EQ(rov.at(0).velocity_ned.norm(), 0);
  const Truth later = rov.at(15);
  EXPECT_NEAR(later.velocity_ned.z(), -speed(2, 5.18, 36.99), 1e-3);
  EXPECT_NEAR(later.velocity_ned.head<2>().norm(), 0, 1e-9);
}

// Two thrusters at 45 degrees; the vehicle heads east.
TEST(OrderedThrusters, TurnsOfTheRearShaftsDriveItAhead) {
  Rov rov;
  for (const int thruster : {rear_starboard, rear_port}) rov.give(thruster, full / 2, 0);
  const double u = speed(2 * push_n(0.5, 51.5) * std::sqrt(0.5), 4.03, 18.18);
  EXPECT_NEAR(rov.at(20).velocity_ned.y(), u, 0.02 * u);
  EXPECT_NEAR(rov.at(20).thruster_radps.at(2), full / 2, 1e-9);
}

// Astern, a vertical thruster pushes up.
TEST(OrderedThrusters, AnOrderBeyondTheLimitIsTheLimit) {
  Rov rov;
  for (const int thruster : {vertical_starboard, vertical_port}) rov.give(thruster, -2 * full, 0);
  EXPECT_NEAR(rov.at(0.9).thruster_radps.at(4), -full, 0.06);
  EXPECT_NEAR(rov.at(3).velocity_ned.z(), -speed(2 + 2 * 40.2, 5.18, 36.99), 0.02);
}

TEST(OrderedThrusters, AShaftFollowsItsOrderByTheLag) {
  Rov rov;
  rov.give(vertical_port, 0.6 * full, 1);
  EXPECT_EQ(rov.at(1).thruster_radps.at(5), 0);
  for (const double after : {0.03, 0.1, 0.254})
    EXPECT_NEAR(rov.at(1 + after).thruster_radps.at(5), 0.6 * full * (1 - std::exp(-after / 0.1)),
                1e-9);
}

TEST(OrderedThrusters, AnyMomentCanBeAskedForAgainWithTheSameBits) {
  Rov rov;
  std::vector<Truth> first;
  for (int i = 0; i < 60; ++i) {  // several blocks of 10.24 s
    rov.give(4 + i % 6, full * std::sin(0.3 * i), i);
    first.push_back(rov.at(i + 0.7071));
  }
  for (int i = 59; i >= 0; i -= 13) {
    const Truth again = rov.at(i + 0.7071);
    const Truth& once = first[static_cast<std::size_t>(i)];
    EXPECT_EQ(again.latitude_rad, once.latitude_rad);
    EXPECT_EQ(again.specific_force, once.specific_force);
    EXPECT_EQ(again.thruster_radps, once.thruster_radps);
  }
}

}  // namespace
}  // namespace drydock::motion
