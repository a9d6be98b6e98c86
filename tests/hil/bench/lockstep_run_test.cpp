// The demo rig in virtual time: from the truth over wire bytes to an estimate, in milliseconds.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "hil/bench/run.hpp"
#include "rig_config/load.hpp"

namespace {

using namespace drydock;

rig_config::Rig demo() {
  return rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/demo.toml").value();
}

summary::Summary run(const rig_config::Rig& rig, double seconds) {
  testing::internal::CaptureStdout();
  bench::RunOptions options;
  options.duration_s = seconds;
  auto summary = bench::run_lockstep(rig, options);
  testing::internal::GetCapturedStdout();
  return summary;
}

/// Removes wall time and memory, which depend on the machine.
std::string json_of_bench(summary::Summary summary) {
  summary.wall_s = 0;
  summary.resident = {};
  return to_json(summary);
}

TEST(LockstepRun, HoldsAsMuchMemoryAfterHalfAnHourAsAfterFiveMinutes) {
  const auto resident = run(demo(), 1800).resident;
  ASSERT_GT(resident.t_s.size(), 100u);
  const std::size_t early = resident.t_s.size() / 6;
  EXPECT_NEAR(resident.t_s[early], 300, 30);
  EXPECT_LT(resident.megabytes.back() - resident.megabytes[early], 1.0);
  EXPECT_GT(resident.megabytes.front(), 1.0) << "a program holds more than that";
}

TEST(LockstepRun, TheSameSeedGivesTheSameOutputToTheLastBit) {
  const auto first = run(demo(), 30);
  const auto second = run(demo(), 30);
  EXPECT_EQ(json_of_bench(first), json_of_bench(second));
  ASSERT_FALSE(first.traces.empty());
  EXPECT_EQ(first.traces[0].roll_deg, second.traces[0].roll_deg);
  EXPECT_EQ(first.traces[0].pitch_sigma_deg, second.traces[0].pitch_sigma_deg);
  for (std::size_t i = 0; i < first.measurements.size(); ++i) {
    EXPECT_EQ(first.measurements[i].value, second.measurements[i].value);
    EXPECT_EQ(first.measurements[i].t_s, second.measurements[i].t_s);
  }
}

/// The bytes of a recording of the demo rig.
std::string recorded(const std::string& path, double seconds) {
  testing::internal::CaptureStdout();
  bench::RunOptions options;
  options.duration_s = seconds;
  options.record = {path, true};
  bench::run_lockstep(demo(), options);
  testing::internal::GetCapturedStdout();
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(LockstepRun, TheSameSeedGivesTheSameRecordingToTheLastByte) {
  const auto path = testing::TempDir() + "drydock-same-recording.mcap";
  const auto first = recorded(path, 20);
  EXPECT_GT(first.size(), 500'000u);
  EXPECT_TRUE(first == recorded(path, 20));
  std::filesystem::remove(path);
}

TEST(LockstepRun, AnotherSeedGivesOtherNoise) {
  auto rig = demo();
  const auto first = run(rig, 10);
  rig.seed += 1;
  EXPECT_NE(first.traces[0].roll_deg, run(rig, 10).traces[0].roll_deg);
}

TEST(LockstepRun, AllSixDevicesStreamAtTheirNominalRateWithoutADamagedByte) {
  const auto summary = run(demo(), 60);
  ASSERT_EQ(summary.devices.size(), 6u);
  for (const auto& d : summary.devices) {
    EXPECT_EQ(d.state, "streaming") << d.name;
    EXPECT_NEAR(d.rate_hz, d.nominal_rate_hz, 0.02 * d.nominal_rate_hz) << d.name;
    EXPECT_EQ(d.bad_checksums, 0u) << d.name;
    EXPECT_EQ(d.reopens, 0u) << d.name;
    EXPECT_TRUE(d.last_error.empty()) << d.last_error;
    EXPECT_EQ(d.bytes_in, d.bytes_good + d.bytes_skipped + d.bytes_held) << d.name;
    EXPECT_EQ(d.provenance, "emulated");
  }
}

TEST(LockstepRun, LevelingStaysWithinHalfADegreeOfTheTruth) {
  const auto summary = run(demo(), 60);
  ASSERT_EQ(summary.estimators.size(), 1u);
  ASSERT_TRUE(summary.estimators[0].whole_run.has_value());
  EXPECT_LT(summary.estimators[0].whole_run->roll_rms_deg, 0.5);
  EXPECT_LT(summary.estimators[0].whole_run->pitch_rms_deg, 0.5);
  EXPECT_NEAR(static_cast<double>(summary.estimators[0].estimates), 6000, 150);
}

TEST(LockstepRun, ARealLinkIsRefusedWithALineThatSaysWhatIsAllowed) {
  auto rig = demo();
  rig.devices[0].link = "serial:/dev/ttyUSB0?baud=115200";
  try {
    run(rig, 1);
    FAIL() << "real hardware has no virtual time";
  } catch (const std::runtime_error& error) {
    testing::internal::GetCapturedStdout();
    EXPECT_NE(std::string{error.what()}.find("allowed with --speed max: pty"), std::string::npos)
        << error.what();
  }
}

}  // namespace
