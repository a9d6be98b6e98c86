// The demo rig in virtual time: from the truth over wire bytes to an estimate, in milliseconds.
#include <gtest/gtest.h>
#include <sys/prctl.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

#include "drivers/recordings/record/recording.hpp"
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
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer's own memory grows; the soak test asks it with a wider limit";
#endif
  prctl(PR_SET_THP_DISABLE, 1, 0, 0, 0);  // one byte of a page of 2 MB would look like a leak
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

/// The messages of each topic of a recording, in its files' order.
using Topics = std::map<std::string, std::vector<std::string>>;
Topics topics_of(const std::vector<std::filesystem::path>& files) {
  Topics topics;
  for (const auto& file : files) {
    auto recording = record::Recording::open(file).value();
    while (const auto event = recording.next()) {
      if (const auto* understood = std::get_if<record::Understood>(&*event))
        topics[understood->channel->topic].emplace_back(understood->cdr.begin(),
                                                        understood->cdr.end());
      else
        topics["raw"].push_back(
            std::to_string(std::get<record::RawEvent>(*event).at().time_since_epoch().count()));
    }
    EXPECT_EQ(recording.damage(), "");
    EXPECT_NE(recording.attachment("rig.toml"), "") << file;
  }
  return topics;
}

TEST(LockstepRun, NoMessageIsLostWhereARecordingIsSplit) {
  std::string folder = testing::TempDir() + "drydock-split-XXXXXX";
  ASSERT_NE(mkdtemp(folder.data()), nullptr);
  const auto record = [&](const std::string& name, record::Split split) {
    testing::internal::CaptureStdout();
    bench::RunOptions options;
    options.duration_s = 20;
    options.record = {folder + "/" + name, false, split};
    bench::run_lockstep(demo(), options);
    testing::internal::GetCapturedStdout();
  };
  record("whole.mcap", {});
  record("time.mcap", {.every = std::chrono::seconds{5}});
  record("size.mcap", {.size = 300'000});
  const auto whole = topics_of({folder + "/whole.mcap"});
  EXPECT_GT(whole.at("raw").size(), 2000U);
  for (const std::string name : {"time", "size"}) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.path().filename().string().starts_with(name)) files.push_back(entry.path());
    std::ranges::sort(files);
    EXPECT_GE(files.size(), 3U) << name;
    EXPECT_TRUE(topics_of(files) == whole) << name;
  }
  std::filesystem::remove_all(folder);
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
