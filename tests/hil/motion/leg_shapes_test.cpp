#include "hil/motion/leg_shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/hil/motion/mechanization.hpp"
#include "tests/hil/motion/missions.hpp"

namespace drydock::motion {
namespace leg_shapes_test {

using rig_config::LegKind;

rig_config::LegConfig a_spiral() {
  return {.kind = LegKind::spiral,
          .duration_s = 120,
          .speed_mps = 2,
          .rate_radps = 3 * degree,
          .end_rate_radps = 1 * degree,
          .ramp_s = 20};
}

rig_config::LegConfig a_zigzag() {
  return {.kind = LegKind::zigzag,
          .duration_s = 220,
          .speed_mps = 2,
          .amplitude_rad = 30 * degree,
          .period_s = 100,
          .rate_radps = 4 * degree};
}

TEST(Spiral, TurnsByTheMeanRateOverItsDurationLessARamp) {
  const Window window{120, 20};
  EXPECT_NEAR(spiral(a_spiral(), window, 120).value, 2 * degree * 100, 1e-12);
  EXPECT_NEAR(spiral(a_spiral(), window, 20).rate, 3 * degree, 1e-12);
  EXPECT_NEAR(spiral(a_spiral(), window, 60).rate, 2 * degree, 1e-12);
  EXPECT_NEAR(spiral(a_spiral(), window, 100).rate, 1 * degree, 1e-12);
  EXPECT_NEAR(spiral(a_spiral(), window, 120).rate, 0, 1e-15);
}

TEST(Zigzag, SwingsToBothSidesAtItsRateAndComesBack) {
  double largest = 0, smallest = 0, fastest = 0;
  for (double t = 0; t <= 220; t += 0.01) {
    const Varying heading = zigzag(a_zigzag(), t);
    largest = std::max(largest, heading.value);
    smallest = std::min(smallest, heading.value);
    fastest = std::max(fastest, std::abs(heading.rate));
  }
  EXPECT_NEAR(largest, 30 * degree, 1e-12);
  EXPECT_NEAR(smallest, -30 * degree, 1e-12);
  EXPECT_NEAR(fastest, 4 * degree, 1e-6);
  EXPECT_NEAR(zigzag(a_zigzag(), 49).value, 30 * degree, 1e-12);
  EXPECT_NEAR(zigzag(a_zigzag(), 99).value, -30 * degree, 1e-12);
  EXPECT_NEAR(zigzag(a_zigzag(), 220).value, 0, 1e-12);
}

TEST(Zigzag, ItsRateIsTheDerivativeOfItsHeading) {
  const double h = 1e-4;
  for (double t = 0.05; t < 219.9; t += 0.37) {
    const double slope =
        (zigzag(a_zigzag(), t + h).value - zigzag(a_zigzag(), t - h).value) / (2 * h);
    EXPECT_NEAR(zigzag(a_zigzag(), t).rate, slope, 1e-9) << t;
  }
}

TEST(KinematicTrajectory, SpiralZigzagAndSurfaceAreFoundAgainByAMechanization) {
  rig_config::MissionConfig mission;
  mission.latitude_rad = 36 * degree;
  mission.depth_m = 30;
  mission.speed_mps = 2;
  mission.legs = {a_spiral(),
                  a_zigzag(),
                  {.kind = LegKind::surface, .duration_s = 100, .speed_mps = 2, .ramp_s = 10}};
  const KinematicTrajectory trajectory(mission, start);
  const MechanizationError error = mechanize(trajectory, start, 440, 0.05);
  EXPECT_LT(error.position_m, 0.01);
  EXPECT_LT(error.attitude_rad, 1e-6);
  EXPECT_NEAR(trajectory.at(at_s(440)).height_m, 0, 1e-9);
  EXPECT_NEAR(trajectory.at(at_s(440)).yaw_rad, 200 * degree - 2 * std::numbers::pi, 1e-9);
}

TEST(KinematicTrajectory, HasNoRudderForATurningCircleAndNoTimeForATightZigzag) {
  rig_config::MissionConfig mission;
  mission.depth_m = 5;
  mission.speed_mps = 2;
  const auto refusal = [&](const rig_config::LegConfig& leg) -> std::string {
    mission.legs = {leg};
    try {
      const KinematicTrajectory trajectory(mission, start);
      return "flown";
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
  };
  EXPECT_EQ(
      refusal(
          {.kind = LegKind::turning_circle, .duration_s = 60, .speed_mps = 2, .rudder_rad = 0.1}),
      "mission leg 1: a turning_circle needs a vehicle with a rudder");
  auto tight = a_zigzag();
  tight.period_s = 40;
  EXPECT_EQ(refusal(tight),
            "mission leg 1: this zigzag needs a rate_degps that turns it in half a period_s, and "
            "two of these");
}

}  // namespace leg_shapes_test
}  // namespace drydock::motion
