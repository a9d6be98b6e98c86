// A recorded run is played again: whole or in part, at once, at a pace, or one message per line.
#include <gtest/gtest.h>

#include <chrono>

#include "hil/replay/replay_bench.hpp"
#include "hil/replay/rigs/recorded_rig.hpp"
#include "tests/hil/replay/recorded_run.hpp"

namespace replay_test {

using namespace recorded_run;

TEST_F(ReplayOfARun, GivesEveryMeasurementAndEstimateAgainToTheLastBit) {
  auto options = quiet("run.mcap");
  options.record.path = file("replay.mcap");
  ASSERT_EQ(replayed(options).exit_code, 0);
  const auto before = results_of(file("run.mcap")), after = results_of(file("replay.mcap"));
  EXPECT_GT(before.at("/imu/data").size(), 1900u);
  EXPECT_GT(before.at("/estimate/leveling").size(), 1900u);
  EXPECT_GT(before.at("/drydock/leveling/innovation/emlog").size(), 30u);  // 2 a second
  ASSERT_EQ(before.size(), after.size());
  for (const auto& [topic, messages] : before) {
    ASSERT_TRUE(after.contains(topic)) << topic;
    EXPECT_TRUE(messages == after.at(topic))
        << topic << ": " << messages.size() << " messages, " << after.at(topic).size() << " again";
  }
}

TEST_F(ReplayOfARun, HandsOnTheFaultsOfTheRecordingWhichNoDriverTells) {
  const auto rig = rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/demo.toml").value();
  const auto start = measurement::stamp_from_ns(rig.start_utc_ns);
  host::RigRecorder recorder(rig, {file("faults.mcap")}, start, record::WhenBehind::wait);
  const std::vector<bus::Fault> faults{{"dvl", "silence", "says nothing", start, {}}};
  recorder.on_faults(faults, start + std::chrono::seconds{1});
  recorder.on_faults({}, start + std::chrono::seconds{3});
  recorder.finish();
  auto options = quiet("faults.mcap");
  options.record.path = file("faults-again.mcap");
  replayed(options);
  const auto before = results_of(file("faults.mcap"));
  EXPECT_EQ(before.at("/drydock/faults").size(), 2u);
  EXPECT_TRUE(before == results_of(file("faults-again.mcap")));
}

TEST_F(ReplayOfARun, OfAReplayIsTheReplayAgainRigFileAndAll) {
  auto options = quiet("run.mcap");
  options.record.path = file("first.mcap");
  ASSERT_EQ(replayed(options).exit_code, 0);
  options = quiet("first.mcap");
  options.record.path = file("second.mcap");
  ASSERT_EQ(replayed(options).exit_code, 0);
  EXPECT_TRUE(results_of(file("first.mcap")) == results_of(file("second.mcap")));
}

TEST_F(ReplayOfARun, OfOneDeviceAndFiveSecondsHasNoOtherAndNoMore) {
  RigReplayOptions options;
  options.recording = file("run.mcap");
  options.part.only = {"dvl"};
  options.part.from = std::chrono::seconds{5};
  options.part.to = std::chrono::seconds{10};
  const auto result = replayed(options);
  EXPECT_EQ(result.exit_code, 0);
  const auto lines = lines_of(result.out);
  EXPECT_NEAR(lines.size(), 25, 1);
  for (const auto& line : lines) EXPECT_EQ(line.at("device"), "dvl");
}

TEST_F(ReplayOfARun, GoesOnAMessageALineWhenStepped) {
  RigReplayOptions options;
  options.recording = file("run.mcap");
  options.step = true;
  EXPECT_EQ(lines_of(replayed(options, "\n\n\nq\n").out).size(), 4u);
  EXPECT_EQ(lines_of(replayed(options, "").out).size(), 1u) << "the end of input ends it";
}

TEST_F(ReplayOfARun, IsAsFarFromTheRecordedTruthAsTheRunWas) {
  auto recording = record::Recording::open(file("run.mcap")).value();
  const RecordedRig rig(recording);
  EXPECT_EQ(rig.trouble(), "");
  boost::asio::io_context io;
  Pace pace(io, 0);
  const record::Selection all;
  ReplayBench bench(recording, rig.rig(), all, {});
  bench.play(pace, [](double) { return true; });
  const auto errors = bench.errors().of(0);
  ASSERT_TRUE(summary_.estimators.at(0).whole_run);
  const auto& was = *summary_.estimators.at(0).whole_run;
  EXPECT_GT(errors.attitudes, 400u) << "the truth comes at least each 40 ms";
  EXPECT_NEAR(errors.roll_deg, was.roll_rms_deg, 0.05 * was.roll_rms_deg);
  EXPECT_NEAR(errors.pitch_deg, was.pitch_rms_deg, 0.05 * was.pitch_rms_deg);
}

TEST_F(ReplayOfARun, AtAPaceTakesItsTimeAndGivesTheSame) {
  auto options = quiet("run.mcap");
  options.quiet = false;
  options.part.to = std::chrono::seconds{3};
  const auto at_once = replayed(options);
  options.speed = 10;
  const auto before = std::chrono::steady_clock::now();
  const auto paced = replayed(options);
  EXPECT_GT(std::chrono::steady_clock::now() - before, std::chrono::milliseconds{280});
  EXPECT_EQ(paced.out, at_once.out);
}

}  // namespace replay_test
