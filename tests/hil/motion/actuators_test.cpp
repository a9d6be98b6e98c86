#include "hil/motion/vehicle/actuators.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace drydock::motion {
namespace actuators_test {

TEST(Actuator, ALagAloneApproachesAsAnExponential) {
  Actuator rudder({.lower = -1, .upper = 1, .lag_s = 0.1});
  rudder.step(0.5, 0.1);
  EXPECT_NEAR(rudder.value(), 0.5 * (1 - std::exp(-1)), 1e-15);
}

TEST(Actuator, ARateAloneIsARamp) {
  Actuator rudder({.lower = -1, .upper = 1, .rate = 0.2});
  rudder.step(-0.5, 2);
  EXPECT_DOUBLE_EQ(rudder.value(), -0.4);
  rudder.step(-0.5, 2);
  EXPECT_DOUBLE_EQ(rudder.value(), -0.5);
}

TEST(Actuator, ARateWithALagIsARampThatEndsAsAnExponential) {
  Actuator rudder({.lower = -1, .upper = 1, .rate = 0.2, .lag_s = 0.5});
  rudder.step(0.5, 2);  // a ramp until the lag asks for 0.2 / s, at a distance of 0.1
  EXPECT_NEAR(rudder.value(), 0.4, 1e-15);
  rudder.step(0.5, 0.5);
  EXPECT_NEAR(rudder.value(), 0.5 - 0.1 * std::exp(-1), 1e-15);
}

TEST(Actuator, WithoutLagAndRateItIsWhereItIsTold) {
  Actuator rudder({.lower = -1, .upper = 1});
  rudder.step(0.5, 1e-9);
  EXPECT_EQ(rudder.value(), 0.5);
}

TEST(Actuator, StopsHoldAndAreLeftAtOnce) {
  Actuator rudder({.lower = -0.35, .upper = 0.35, .rate = 0.1}, 9);
  EXPECT_EQ(rudder.value(), 0.35);
  rudder.step(100, 60);
  EXPECT_EQ(rudder.value(), 0.35);
  rudder.step(-100, 1);  // no wind-up at the stop
  EXPECT_NEAR(rudder.value(), 0.25, 1e-15);
}

/// A number in (-size, size).
rc::Gen<double> number(double size) {
  return rc::gen::map(rc::gen::inRange(-1000, 1000), [size](int i) { return i * size / 1000; });
}

RC_GTEST_PROP(Actuator, ManySmallStepsEndWhereOneLargeStepDoes, ()) {
  const double lag = std::abs(*number(0.5)), rate = 0.01 + std::abs(*number(1));
  Actuator once({.lower = -1, .upper = 1, .rate = rate, .lag_s = lag}, *number(1));
  Actuator often = once;
  const double command = *number(2), duration = std::abs(*number(5));
  once.step(command, duration);
  for (int i = 0; i < 64; ++i) often.step(command, duration / 64);
  RC_ASSERT(std::abs(once.value() - often.value()) < 1e-12);
}

RC_GTEST_PROP(Actuator, NeverBreaksItsLimits, ()) {
  Actuator rudder({.lower = -0.3, .upper = 0.2, .rate = 0.5, .lag_s = std::abs(*number(0.2))});
  for (const int command : *rc::gen::container<std::vector<int>>(rc::gen::inRange(-100, 100))) {
    const double before = rudder.value();
    rudder.step(command / 100.0, 0.02);
    RC_ASSERT(rudder.value() >= -0.3 && rudder.value() <= 0.2);
    RC_ASSERT(std::abs(rudder.value() - before) <= 0.5 * 0.02 + 1e-15);
  }
}

TEST(Actuators, CommandedSpeedIsWhatThePropellerTurnsFor) {
  rig_config::VehicleConfig config;
  config.rudder.limit_rad = config.stern_planes.limit_rad = config.bow_planes.limit_rad = 0.35;
  config.propeller = {.advance_m = 0.012, .limit_radps = 250, .rate_limit_radps2 = {}, .lag_s = 0};
  Actuators actuators(config, 1.2);
  EXPECT_NEAR(actuators.propeller_radps(), 100, 1e-12);
  actuators.step({0.1, 0.5, -0.2, 2.4}, 0.01);
  EXPECT_NEAR(actuators.propeller_radps(), 200, 1e-12);
  EXPECT_NEAR(actuators.control().u_c, 2.4, 1e-12);
  EXPECT_EQ(actuators.control().delta_r, 0.1);
  EXPECT_EQ(actuators.control().delta_s, 0.35);
  EXPECT_EQ(actuators.control().delta_b, -0.2);
  actuators.step({0, 0, 0, -1}, 0.01);  // the propeller does not turn astern
  EXPECT_EQ(actuators.control().u_c, 0);
  actuators.step({0, 0, 0, 9}, 0.01);
  EXPECT_NEAR(actuators.control().u_c, 3, 1e-12);
}

TEST(Actuators, IdealOnesKeepTheirStopsAlone) {
  rig_config::VehicleConfig config;
  config.rudder = {.limit_rad = 0.35, .rate_limit_radps = 0.04, .lag_s = 0.1};
  config.propeller = {.advance_m = 0.012, .limit_radps = 250, .rate_limit_radps2 = 5, .lag_s = 0.1};
  Actuators actuators(with_ideal_actuators(config), 0);
  actuators.step({1, 0, 0, 9}, 1e-6);
  EXPECT_EQ(actuators.control().delta_r, 0.35);
  EXPECT_EQ(actuators.propeller_radps(), 250);
}

}  // namespace actuators_test
}  // namespace drydock::motion
