#include <gmock/gmock.h>

#include <algorithm>

#include "tests/hil/steer/json_autopilot.hpp"

namespace drydock::steer::test {
namespace {

using testing::HasSubstr;

const Pulses idle(6, 1500);

TEST(AutopilotSession, AnswersWithOneLineBetweenNewlinesWithoutBlanks) {
  Loop loop(mission_of("bluerov2.toml"));
  const auto bytes = packet(18458, 400, 1, Pulses(16, 1500));
  const std::string line{loop.session_.answer(bytes, bench_s(0))};
  EXPECT_EQ(line.front(), '\n');
  EXPECT_EQ(line.back(), '\n');
  EXPECT_EQ(std::ranges::count(line, '\n'), 2);
  EXPECT_EQ(line.find(' '), std::string::npos);
  EXPECT_EQ(line.find("nan"), std::string::npos);
}

TEST(AutopilotSession, AtRestItTellsItsPlaceItsHeadingAndGravity) {
  Loop loop(mission_of("bluerov2.toml"));
  const Physics first = loop.step(idle);
  EXPECT_NEAR(first.position[2], 5, 1e-4);
  EXPECT_NEAR(first.heading_rad(), 1.5707963, 1e-6);
  // Normal gravity at 47 degrees is 9.8072 m/s2; the ROV floats up with 2 N on 11.5 + 14.57 kg.
  EXPECT_NEAR(first.accelerometer[2], -9.8072 - 2 / 26.07, 1e-3);
  EXPECT_NEAR(first.range_m, 45, 1e-3);
}

class RatesOfAutopilots : public testing::TestWithParam<int> {};

TEST_P(RatesOfAutopilots, ItsTimeAdvancesByTheStepsOfTheAutopilot) {
  const int rate = GetParam();
  Loop loop(mission_of("bluerov2.toml"), static_cast<std::uint16_t>(rate));
  const double first = loop.step(idle).timestamp_s;
  double last = first;
  for (int i = 0; i < rate; ++i) {
    const double now = loop.step(idle).timestamp_s;
    ASSERT_NEAR(now - last, 1.0 / rate, 2e-9);
    last = now;
  }
  EXPECT_NEAR(last - first, 1, 1e-7);
}

TEST_P(RatesOfAutopilots, TheMotionDoesNotDependOnTheRate) {
  Loop reference(mission_of("bluerov2.toml"), 400);
  Loop loop(mission_of("bluerov2.toml"), static_cast<std::uint16_t>(GetParam()));
  const auto ahead = vectored(0.1, -0.2, 0.4, 0);
  const Physics a = reference.hold(ahead, 4), b = loop.hold(ahead, 4);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(a.position.at(i), b.position.at(i), 2e-3);
  EXPECT_NEAR(a.heading_rad(), b.heading_rad(), 2e-3);
}

INSTANTIATE_TEST_SUITE_P(Hz, RatesOfAutopilots, testing::Values(100, 200, 400, 1200));

TEST(AutopilotSession, ARepeatedPacketGetsTheSameAnswerAndNoStep) {
  Loop loop(mission_of("bluerov2.toml"));
  loop.hold(vectored(0, -0.5, 0.5, 0), 1);
  const auto again = packet(18458, 400, loop.count_, Pulses(16, 1500));
  const std::string one{loop.session_.answer(again, bench_s(2))};
  const std::string two{loop.session_.answer(again, bench_s(3))};
  EXPECT_EQ(one, two);
  EXPECT_NEAR(read(one).timestamp_s, 1, 1e-9);
  EXPECT_EQ(loop.session_.counters().repeats, 2u);
  EXPECT_EQ(loop.session_.counters().steps, 400u);
  const auto next = packet(18458, 400, loop.count_ + 1, Pulses(16, 1500));
  EXPECT_NEAR(read(loop.session_.answer(next, bench_s(3))).timestamp_s, 1.0025, 1e-9);
}

TEST(AutopilotSession, TheFormWith32OutputsDrivesTheSameThrusters) {
  Loop sixteen(mission_of("bluerov2.toml")), thirty_two(mission_of("bluerov2.toml"));
  Pulses pulses = vectored(0, 0, 1, 0);
  sixteen.hold(pulses, 1);
  pulses.resize(32, 1500);
  for (std::uint32_t i = 1; i <= 400; ++i)
    thirty_two.state_ =
        read(thirty_two.session_.answer(packet(29569, 400, i, pulses), bench_s(i / 400.0)));
  EXPECT_EQ(thirty_two.state_.position, sixteen.state_.position);
  EXPECT_GT(thirty_two.state_.position[1], 0.3) << "its heading is east";
}

TEST(AutopilotSession, WhatIsNoPacketIsCountedAndGetsNoAnswer) {
  Loop loop(mission_of("bluerov2.toml"));
  auto wrong_magic = packet(18459, 400, 1, Pulses(16, 1500));
  auto no_rate = packet(18458, 0, 1, Pulses(16, 1500));
  auto too_long = packet(18458, 400, 1, Pulses(17, 1500));
  auto too_short = packet(18458, 400, 1, Pulses(15, 1500));
  for (const auto& bad : {wrong_magic, no_rate, too_long, too_short, std::vector<std::uint8_t>{}})
    EXPECT_EQ(loop.session_.answer(bad, bench_s(0)), "");
  EXPECT_EQ(loop.session_.counters().refused, 5u);
  EXPECT_EQ(loop.session_.counters().steps, 0u);
}

TEST(AutopilotSession, LostPacketsAreCountedAndAnotherRunOfTheAutopilotFindsItsOwnTime) {
  Loop loop(mission_of("bluerov2.toml"));
  loop.step(idle);
  loop.count_ += 3;
  loop.step(idle);
  const double depth = loop.hold(vectored(0, -0.5, 0, 0), 3).position[2];
  const auto began = static_cast<double>(loop.count_) / 400;
  const auto say = [&](std::uint32_t count, double after_s) {
    return read(loop.session_.answer(packet(18458, 400, count, Pulses(16, 1500)),
                                     bench_s(began + after_s)));
  };
  const Physics zero = say(0, 4), one = say(1, 4.0025);
  EXPECT_EQ(loop.session_.counters().lost, 3u);
  EXPECT_EQ(loop.session_.counters().restarts, 1u);
  EXPECT_NEAR(zero.timestamp_s, 1 / 400.0, 1e-9);
  EXPECT_NEAR(one.timestamp_s, 2 / 400.0, 1e-9);
  EXPECT_NEAR(one.position[2], depth, 0.01) << "the vehicle goes on where it is";
  EXPECT_THAT(loop.session_.notes().front(), HasSubstr("1204 steps"));
}

TEST(AutopilotSession, ADatagramThatWasOvertakenMakesNoStep) {
  Loop loop(mission_of("bluerov2.toml"));
  loop.hold(idle, 1);
  const auto late = packet(18458, 400, loop.count_ - 2, Pulses(16, 1500));
  EXPECT_EQ(loop.session_.answer(late, bench_s(1)), "");
  EXPECT_EQ(loop.session_.counters().late, 1u);
  EXPECT_NEAR(loop.step(idle).timestamp_s, 401 / 400.0, 1e-9);
  EXPECT_EQ(loop.session_.counters().lost, 0u);
}

TEST(AutopilotSession, ACountThatPassesItsEndIsNoRestart) {
  Loop loop(mission_of("bluerov2.toml"));
  loop.count_ = 0xFFFFFFFD;
  for (int i = 0; i < 4; ++i) loop.step(idle);
  EXPECT_EQ(loop.count_, 1u);
  EXPECT_NEAR(loop.state_.timestamp_s, 4 / 400.0, 1e-9);
  EXPECT_EQ(loop.session_.counters().restarts + loop.session_.counters().lost, 0u);
}

TEST(AutopilotSession, ASecondAutopilotIsAnsweredOnceTheFirstHasBeenSilentForTwoSeconds) {
  Loop loop(mission_of("bluerov2.toml"));
  constexpr Sender first = 1, second = 2;
  const auto say = [&](std::uint32_t count, double at_s, Sender from) {
    return std::string(
        loop.session_.answer(packet(18458, 400, count, Pulses(16, 1500)), bench_s(at_s), from));
  };
  EXPECT_NE(say(1000, 0, first), "");
  EXPECT_EQ(say(0, 0.1, second), "");
  EXPECT_NE(say(1001, 1, first), "");
  EXPECT_EQ(say(0, 2.9, second), "");
  EXPECT_EQ(loop.session_.counters().others, 2u);
  EXPECT_NEAR(read(say(0, 3.1, second)).timestamp_s, 1 / 400.0, 1e-9);
  EXPECT_EQ(say(1002, 3.2, first), "") << "it has lost its place";
}

/// Closed forms of two steady states: damping equals the push, of four thrusters at 45 degrees, and
/// of the vertical ones less the 2 N of buoyancy.
TEST(AutopilotSession, AtASteadySpeedDragEqualsPush) {
  const double share = std::pow((0.5 - 0.07) / 0.93, 1.5);
  const auto speed = [](double push, double linear, double quadratic) {
    return (-linear + std::sqrt(linear * linear + 4 * quadratic * push)) / (2 * quadratic);
  };
  Loop ahead(mission_of("bluerov2.toml", 30)), down(mission_of("bluerov2.toml"));
  const Physics fast = ahead.hold(vectored(0, 0, 0.5, 0), 15);
  const double u = speed((2 * 51.5 + 2 * 40.2) * share / std::sqrt(2.0), 4.03, 18.18);
  EXPECT_NEAR(std::hypot(fast.velocity[0], fast.velocity[1]), u, 0.02 * u);
  const Physics sinking = down.hold(vectored(0, -0.5, 0, 0), 15);
  EXPECT_NEAR(sinking.velocity[2], speed(2 * 51.5 * share - 2, 5.18, 36.99), 0.005);
}

TEST(AutopilotSession, EachAxisOfTheFrameMovesTheVehicleToItsSide) {
  const auto moved = [](const Pulses& pulses) {
    Loop loop(mission_of("bluerov2.toml"));
    return loop.hold(pulses, 1);
  };
  EXPECT_GT(moved(vectored(0, 0, 0.5, 0)).position[1], 0.05) << "ahead is east";
  EXPECT_LT(moved(vectored(0, 0, 0, 0.5)).position[0], -0.05) << "starboard is south";
  EXPECT_LT(moved(vectored(0, 0.5, 0, 0)).position[2], 4.95) << "up";
  EXPECT_GT(moved(vectored(0, -0.5, 0, 0)).position[2], 5.05) << "down";
  EXPECT_GT(moved(vectored(0.3, 0, 0, 0)).heading_rad(), 1.65) << "to starboard";
}

TEST(AutopilotSession, ASmallControllerDivesAndHoldsDepthAndHeading) {
  Loop loop(mission_of("bluerov2.toml", 0));
  double wind_up = 0;
  const double wanted_m = 10, wanted_rad = 2.6;
  double worst_m = 0, worst_rad = 0;
  Physics now = loop.step(idle);
  for (int i = 0; i < 120 * 400; ++i) {
    const double low = wanted_m - now.position[2];
    wind_up = std::clamp(wind_up + 0.02 * low / 400, -0.3, 0.3);
    const double down = std::clamp(0.3 * low - 0.4 * now.velocity[2] + wind_up, -0.6, 0.6);
    const double off = std::remainder(wanted_rad - now.heading_rad(), 2 * 3.14159265358979);
    const double yaw = std::clamp(0.5 * off - 0.3 * now.gyro[2], -0.4, 0.4);
    now = loop.step(vectored(yaw, -down, 0, 0));
    if (i < 100 * 400) continue;
    worst_m = std::max(worst_m, std::abs(wanted_m - now.position[2]));
    worst_rad = std::max(worst_rad, std::abs(off));
  }
  EXPECT_LT(worst_m, 0.1);
  EXPECT_LT(worst_rad, 0.1) << "within the dead band of the thrusters";
}

TEST(AutopilotSession, AVehicleThatFloatsUpStopsAtTheSurface) {
  Loop loop(mission_of("bluerov2.toml", 2));
  const Physics up = loop.hold(vectored(0, 1, 0, 0), 20);
  EXPECT_GE(up.position[2], -0.26);
  const Physics floating = loop.hold(idle, 60);
  // 2 N of 114.8 N come out of the water: 0.25 m times 2 / 114.8.
  EXPECT_NEAR(floating.position[2], -0.0044, 0.002);
}

TEST(AutopilotSession, AVehicleWithFinsTurnsAndDivesAsThreeThrustersWould) {
  const auto pulses = [](double forward, double yaw, double up) {
    const auto us = [](double output) {
      return static_cast<std::uint16_t>(std::lround(1500 + 400 * std::clamp(output, -1.0, 1.0)));
    };
    return Pulses{us(forward - yaw), us(forward + yaw), us(-up)};
  };
  Loop ahead(mission_of("nps-auv-ii.toml", 10), 100), right(mission_of("nps-auv-ii.toml", 10), 100),
      down(mission_of("nps-auv-ii.toml", 10), 100);
  const Physics straight = ahead.hold(pulses(0.6, 0, 0), 120);
  // The propeller gives 0.012 m/s per rad/s; 0.6 of 2500 rpm is uc = 1.885 m/s. Surge alone has
  // du/dt = k (uc^2 - u^2) with k = 0.0092018 1/m, so after 120 s u = uc tanh(k uc t) = 1.8272 m/s.
  EXPECT_NEAR(std::hypot(straight.velocity[0], straight.velocity[1]), 1.8272, 0.005);
  EXPECT_NEAR(straight.heading_rad(), 1.5708, 0.02);
  right.hold(pulses(0.6, 0, 0), 60);
  EXPECT_GT(right.hold(pulses(0.6, 0.3, 0), 5).heading_rad(), 1.60);
  down.hold(pulses(0.6, 0, 0), 60);
  EXPECT_GT(down.hold(pulses(0.6, 0, -0.3), 15).position[2], 10.5);
}

TEST(SteeredTrajectory, SensorsSeeTheMotionAtBenchTimeAndStandStillWithTheAutopilot) {
  Loop loop(mission_of("bluerov2.toml"));
  loop.hold(vectored(0, 0, 1, 0), 5);
  const auto& motion = loop.motion_;
  const auto before = motion.at(bench_s(4.9)), then = motion.at(bench_s(5));
  const double speed = then.velocity_ned.norm();
  const double way =
      (then.longitude_rad - before.longitude_rad) * 6'389'587 * std::cos(47 * 3.14159265 / 180);
  EXPECT_NEAR(way, 0.1 * speed, 0.003 * speed);
  EXPECT_EQ(motion.at(bench_s(9)).longitude_rad, then.longitude_rad);
  // The autopilot slept for 3 s: its next step follows the last one.
  loop.session_.answer(packet(18458, 400, loop.count_ + 1, Pulses(16, 1500)), bench_s(8));
  EXPECT_EQ(motion.waits(), 1u);
  EXPECT_NEAR(motion.motion_s(), 5.0025, 1e-9);
  // Bench time 7.9 is now time 4.9025 of the motion.
  const double moved = motion.at(bench_s(7.9)).longitude_rad - before.longitude_rad;
  EXPECT_NEAR(moved, (then.longitude_rad - before.longitude_rad) / 40, 1e-11);
}

constexpr auto hard_to_port = [](double starboard, double port) {
  const auto pulse = [](double output) {
    return static_cast<std::uint16_t>(std::lround(1500 + 400 * output));
  };
  return Pulses{pulse(starboard), pulse(port), 1500};
};

// The rudder of this vehicle's file turns by 2.5 degrees a second, to 20 degrees.
TEST(AutopilotSession, ASurfaceThatSticksOnItsWayStandsThereAndALateOneWaits) {
  Loop stuck(mission_of("nps-auv-ii.toml"), 100), late(mission_of("nps-auv-ii.toml"), 100);
  const Pulses port = hard_to_port(1, -1), centre = hard_to_port(0, 0);
  stuck.hold(port, 4);
  const double there = stuck.motion_.latest().rudder_rad;
  EXPECT_NEAR(there, 4 * 2.5 * degree, 0.3 * degree);
  stuck.session_.set_troubles({{"rudder", {.stuck = true}}});
  stuck.hold(centre, 20);
  EXPECT_NEAR(stuck.motion_.latest().rudder_rad, there, 1e-3);
  stuck.session_.set_troubles({});
  stuck.hold(centre, 20);
  EXPECT_NEAR(stuck.motion_.latest().rudder_rad, 0, 1e-4);

  late.session_.set_troubles({{"rudder", {.late = std::chrono::seconds{2}}}});
  late.hold(port, 6);
  EXPECT_NEAR(late.motion_.latest().rudder_rad, 4 * 2.5 * degree, 0.3 * degree);
}

// Without its vertical thrusters the vehicle floats up.
TEST(AutopilotSession, ALostThrusterPushesNoMoreAndOneThatHearsNothingStopsAfterASecond) {
  Loop lost(mission_of("bluerov2.toml"), 100), deaf(mission_of("bluerov2.toml"), 100);
  const Pulses down = vectored(0, -1, 0, 0);
  lost.session_.set_troubles(
      {{"vertical-starboard", {.powerless = true}}, {"vertical-port", {.stuck = true}}});
  EXPECT_LT(lost.hold(down, 3).velocity[2], 0) << "its buoyancy alone moves it";
  deaf.hold(down, 3);
  deaf.session_.set_troubles(
      {{"vertical-starboard", {.deaf = true}}, {"vertical-port", {.deaf = true}}});
  EXPECT_GT(deaf.hold(idle, 0.9).velocity[2], 0.5);
  EXPECT_EQ(deaf.session_.counters().timeouts, 0u);
  EXPECT_LT(deaf.hold(down, 10).velocity[2], 0);
  EXPECT_EQ(deaf.session_.counters().timeouts, 2u);
  EXPECT_THAT(deaf.session_.notes(), testing::Contains(HasSubstr("2 times a joint")));
}

}  // namespace
}  // namespace drydock::steer::test
