#include "hil/pilot/step_response.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace drydock::pilot {
namespace {

using rig_config::LegKind;

/// 5 s straight, a turn by 90 degrees in 0.1 s, then straight: a step for any vehicle.
rig_config::MissionConfig quick_turn() {
  rig_config::MissionConfig mission;
  mission.legs = {{.kind = LegKind::straight, .duration_s = 5},
                  {.kind = LegKind::turn, .duration_s = 0.1, .turn_rad = 1},
                  {.kind = LegKind::straight, .duration_s = 60}};
  return mission;
}

LoopTrace trace_of(double seconds, double step_s, const std::function<double(double)>& heading) {
  LoopTrace trace;
  for (double t = 0; t < seconds; t += step_s) {
    trace.t_s.push_back(t);
    trace.heading_deg.wanted.push_back(t < 5.05 ? 0 : 90);
    trace.heading_deg.is.push_back(heading(t - 5));
    trace.depth_m.wanted.push_back(3);
    trace.depth_m.is.push_back(3);
    trace.speed_mps.wanted.push_back(0);
    trace.speed_mps.is.push_back(0);
  }
  return trace;
}

// A second-order system with damping z and natural frequency w overshoots by exp(-z pi / sqrt(1 -
// z^2)).
TEST(StepResponse, OvershootAndSettlingAreThoseOfASecondOrderSystem) {
  const double z = 0.4, w = 1.2, damped = w * std::sqrt(1 - z * z);
  const auto heading = [&](double t) {
    if (t < 0) return 0.0;
    return 90 * (1 - std::exp(-z * w * t) *
                         (std::cos(damped * t) + z * w / damped * std::sin(damped * t)));
  };
  const auto all = step_responses(quick_turn(), trace_of(65, 0.01, heading));
  ASSERT_EQ(all.size(), 1);
  EXPECT_EQ(all[0].quantity, "heading");
  EXPECT_EQ(all[0].begins_s, 5);
  EXPECT_EQ(all[0].from, 0);
  EXPECT_EQ(all[0].to, 90);
  EXPECT_NEAR(all[0].overshoot, 90 * std::exp(-z * std::numbers::pi / std::sqrt(1 - z * z)), 0.01);
  ASSERT_TRUE(all[0].settling_s);
  double last_outside = 0;
  for (double t = 0; t < 30; t += 1e-3)
    if (std::abs(heading(t) - 90) > 4.5) last_outside = t;
  EXPECT_NEAR(*all[0].settling_s, last_outside, 0.03);
  EXPECT_NEAR(all[0].steady_error.value(), 0, 1e-6);
}

TEST(StepResponse, AVehicleThatStaysAsideHasASteadyErrorAndDoesNotSettle) {
  const auto all =
      step_responses(quick_turn(), trace_of(65, 0.1, [](double t) { return t < 0 ? 0.0 : 84.0; }));
  ASSERT_EQ(all.size(), 1);
  EXPECT_EQ(all[0].overshoot, 0);
  EXPECT_FALSE(all[0].settling_s);
  EXPECT_NEAR(all[0].steady_error.value(), -6, 1e-9);
}

TEST(StepResponse, ALegThatHasNotEndedIsNotJudged) {
  EXPECT_TRUE(step_responses(quick_turn(), trace_of(5, 0.1, [](double) { return 0.0; })).empty());
}

}  // namespace
}  // namespace drydock::pilot
