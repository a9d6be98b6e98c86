// A vehicle that is steered over its wires, in virtual time.
#include <gtest/gtest.h>

#include <algorithm>

#include "hil/bench/run.hpp"
#include "rig_config/fault_vocabulary.hpp"
#include "rig_config/load.hpp"

namespace drydock::bench {
namespace {

rig_config::Rig loop_rig() {
  return rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/loop.toml").value();
}

rig_config::FaultConfig fault(const char* device, rig_config::FaultKind kind, double start_s,
                              std::optional<double> for_s = {}) {
  rig_config::FaultConfig fault;
  fault.device = device;
  fault.kind = kind;
  fault.start_s = start_s;
  fault.for_s = for_s;
  return fault;
}

summary::Summary sail(const rig_config::Rig& rig, double seconds) {
  testing::internal::CaptureStdout();
  RunOptions options;
  options.duration_s = seconds;
  options.quiet = true;
  auto summary = run_lockstep(rig, options);
  testing::internal::GetCapturedStdout();
  return summary;
}

// The autopilots inside the simulation act 100 times a second on the truth; over the wires they act
// 20 times on measurements that are up to 0.2 s old (the log's), through numbers of 0.0001 rad and
// 0.01 m/s.
TEST(LoopRun, SailsItsLegsAsTheAutopilotsInsideTheSimulationDo) {
  const auto summary = sail(loop_rig(), 150);
  ASSERT_TRUE(summary.loop);
  const auto& loop = *summary.loop;
  EXPECT_LT(loop.heading_off_deg, 0.5);
  EXPECT_LT(loop.depth_off_m, 0.1);
  EXPECT_LT(loop.speed_off_mps, 0.01);
  EXPECT_LT(loop.place_off_m, 0.3);
  ASSERT_EQ(loop.responses.size(), 3);
  EXPECT_NEAR(loop.responses[0].to, 90, 1e-9);
  EXPECT_NEAR(loop.responses[1].to, 7, 1e-9);
  EXPECT_NEAR(loop.responses[2].to, 1.4, 1e-9);
  for (const auto& response : loop.responses) {
    EXPECT_TRUE(response.settling_s) << response.quantity;
    EXPECT_LT(response.overshoot, 0.2 * std::abs(response.to - response.from));
    EXPECT_LT(std::abs(response.steady_error.value()), 0.1 * std::abs(response.to - response.from));
  }
}

TEST(LoopRun, TheSameSeedGivesTheSameLoopToTheLastBit) {
  const auto first = sail(loop_rig(), 20), second = sail(loop_rig(), 20);
  EXPECT_EQ(first.loop->trace.heading_deg.is, second.loop->trace.heading_deg.is);
  EXPECT_EQ(first.loop->trace.depth_m.is, second.loop->trace.depth_m.is);
}

/// The largest distance from the wanted depth after `from_s`.
double worst_depth(const summary::Summary& summary, double from_s) {
  const auto& trace = summary.loop->trace;
  double worst = 0;
  for (std::size_t i = 0; i < trace.t_s.size(); ++i)
    if (trace.t_s[i] >= from_s)
      worst = std::max(worst, std::abs(trace.depth_m.is[i] - trace.depth_m.wanted[i]));
  return worst;
}

// The legs take 210 s. A run that only dived would be 4 m deeper after each lap.
TEST(LoopRun, StaysBetweenItsTwoDepthsForTenLaps) {
  const auto summary = sail(loop_rig(), 2100);
  const auto& depth = summary.loop->trace.depth_m.is;
  EXPECT_GT(std::ranges::min(depth), 2.2);
  EXPECT_LT(std::ranges::max(depth), 7.8);
  EXPECT_NEAR(depth.back(), 3, 0.5);
  for (const auto& finding : summary.findings)
    ADD_FAILURE() << finding.device << ' ' << finding.cause << " at " << finding.found_s;
}

TEST(LoopRun, StuckPlanesMissTheDive) {
  auto rig = loop_rig();
  rig.faults = {fault("stern_planes", rig_config::FaultKind::stuck, 40)};
  EXPECT_GT(worst_depth(sail(rig, 110), 100), 1);
  EXPECT_LT(worst_depth(sail(loop_rig(), 110), 100), 0.3);
}

TEST(LoopRun, AShaftThatLosesItsPowerStops) {
  auto rig = loop_rig();
  rig.faults = {fault("shaft", rig_config::FaultKind::off, 20, 20)};
  const auto speeds = sail(rig, 90).loop->trace.speed_mps.is;
  EXPECT_LT(speeds[390], 1.4);
  EXPECT_GT(speeds[890], 1.6) << "the autopilot takes the drive into operation again";
}

TEST(LoopRun, WithoutACompassNobodyGivesOrdersAndTheVehicleSlows) {
  auto rig = loop_rig();
  rig.faults = {fault("compass", rig_config::FaultKind::off, 20)};
  EXPECT_LT(sail(rig, 60).loop->trace.speed_mps.is.back(), 1.2);
}

}  // namespace
}  // namespace drydock::bench
