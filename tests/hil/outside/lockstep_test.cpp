// The clients of docs/build/external-estimator.md on the demo rig, in step with virtual time.
#include <gtest/gtest.h>

#include "tests/hil/outside/outside_rig.hpp"

namespace outside_lockstep_test {

using namespace outside_rig;

const std::string clients = DRYDOCK_SOURCE_DIR "/docs/build/clients/";
const std::string in_python = "[\"python3\", \"" + clients + "leveling_client.py\"]";
const std::string in_cpp = "[\"" DRYDOCK_LEVELING_CLIENT "\"]";

drydock::summary::Summary demo_with(const std::string& command, const std::string& more = {}) {
  auto rig = drydock::rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/demo.toml").value();
  const Folder folder;
  std::ofstream(folder / "mine.toml") << one_imu + estimator("attitude", more, command);
  auto mine = drydock::rig_config::load_rig(folder / "mine.toml").value().estimators.at(0);
  rig.estimators.push_back(mine);
  testing::internal::CaptureStdout();
  drydock::bench::RunOptions options;
  options.duration_s = 20;
  auto summary = drydock::bench::run_lockstep(rig, options);
  testing::internal::GetCapturedStdout();
  return summary;
}

TEST(OutsideInLockstep, TwoRunsAreTheSameToTheLastBit) {
  const auto first = demo_with(in_cpp), second = demo_with(in_cpp);
  ASSERT_EQ(first.estimators.at(1).name, "mine");
  ASSERT_GE(first.traces.at(1).roll_deg.size(), 1000U);
  EXPECT_EQ(first.traces[1].roll_deg, second.traces.at(1).roll_deg);
  EXPECT_EQ(first.traces[1].pitch_deg, second.traces[1].pitch_deg);
  EXPECT_EQ(first.estimators[1].whole_run->nees_mean, second.estimators.at(1).whole_run->nees_mean);
  EXPECT_EQ(first.estimators[1].program->steps, second.estimators[1].program->steps);
}

TEST(OutsideInLockstep, PythonAndCppGiveTheSameAngles) {
  const auto cpp = demo_with(in_cpp), python = demo_with(in_python);
  const auto& ours = cpp.traces.at(1).pitch_deg;
  const auto& theirs = python.traces.at(1).pitch_deg;
  ASSERT_EQ(ours.size(), theirs.size());
  for (std::size_t i = 0; i < ours.size(); ++i) ASSERT_NEAR(ours[i], theirs[i], 1e-9);
}

TEST(OutsideInLockstep, TheLengthOfAStepDoesNotChangeTheEstimates) {
  const auto fine = demo_with(in_cpp, "step_s = 0.01"), coarse = demo_with(in_cpp, "step_s = 0.7");
  EXPECT_GT(fine.estimators.at(1).program->steps, 1900U);
  EXPECT_LE(coarse.estimators.at(1).program->steps, 30U);
  EXPECT_EQ(fine.traces.at(1).roll_deg, coarse.traces.at(1).roll_deg);
  EXPECT_EQ(fine.estimators[1].estimates, coarse.estimators[1].estimates);
}

TEST(OutsideInLockstep, TheOtherEstimatorsDoNotNoticeIt) {
  const auto with = demo_with(in_cpp);
  auto rig = drydock::rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/demo.toml").value();
  testing::internal::CaptureStdout();
  drydock::bench::RunOptions options;
  options.duration_s = 20;
  const auto without = drydock::bench::run_lockstep(rig, options);
  testing::internal::GetCapturedStdout();
  EXPECT_EQ(with.traces.at(0).roll_deg, without.traces.at(0).roll_deg);
}

TEST(OutsideInLockstep, EveryStepIsAnsweredOnce) {
  const auto summary = demo_with(in_cpp);
  const auto& program = *summary.estimators.at(1).program;
  EXPECT_EQ(program.answers, program.steps);
  EXPECT_EQ(program.faults(), 0U);
  EXPECT_GE(program.steps, 395U);
  EXPECT_LE(program.steps, 401U) << "20 s of 50 ms";
  EXPECT_EQ(summary.estimators[1].estimates, summary.devices.at(3).messages)
      << "one for each sample of the IMU, those of the last step too";
}

}  // namespace outside_lockstep_test
