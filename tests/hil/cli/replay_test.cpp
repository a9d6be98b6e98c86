// The demo rig in virtual time, recorded, and its recording played through drivers and estimators.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "drivers/mcap/file_sink.hpp"
#include "drivers/record/recorder.hpp"
#include "hil/cli/replay/recorded_rig.hpp"
#include "hil/cli/replay/replay_bench.hpp"
#include "hil/cli/replay/replay_rig.hpp"
#include "hil/cli/run.hpp"
#include "rig_config/load.hpp"
#include "tests/drivers/cli/captured.hpp"

namespace replay_test {

using namespace drydock;
using namespace drydock::cli;
namespace fs = std::filesystem;

/// Everything understood but truth and health, by topic: the messages' bytes with their times.
std::map<std::string, std::vector<std::string>> results_of(const std::string& path) {
  std::map<std::string, std::vector<std::string>> topics;
  auto recording = record::Recording::open(path).value();
  while (const auto event = recording.next()) {
    const auto* message = std::get_if<record::Understood>(&*event);
    if (message == nullptr) continue;
    const auto& topic = message->channel->topic;
    if (topic == "/diagnostics" || topic.starts_with("/estimate/truth")) continue;
    topics[topic].push_back(std::to_string(message->at.time_since_epoch().count()) +
                            std::string(message->cdr.begin(), message->cdr.end()));
  }
  return topics;
}

struct Replayed {
  int exit_code;
  std::string out, err;
};

Replayed replayed(const RigReplayOptions& options, const std::string& typed = "") {
  MemoryFile out, err;
  std::FILE* in = std::tmpfile();
  std::fputs(typed.c_str(), in);
  std::fflush(in);
  ::lseek(fileno(in), 0, SEEK_SET);
  const int code = replay_rig(options, in, out.file(), err.file());
  std::fclose(in);
  return {code, out.text(), err.text()};
}

std::vector<nlohmann::json> lines_of(const std::string& text) {
  std::vector<nlohmann::json> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(nlohmann::json::parse(line));
  return lines;
}

/// Twenty seconds of the demo rig, with two seeds.
class ReplayOfARun : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = fs::temp_directory_path() / ("replay-test-" + std::to_string(::getpid()));
    fs::create_directories(folder_);
    summary_ = record("run.mcap", 1);
    record("other-seed.mcap", 2);
  }
  static void TearDownTestSuite() { fs::remove_all(folder_); }

  static Summary record(const std::string& name, std::uint64_t seed) {
    auto rig = rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/demo.toml").value();
    rig.seed = seed;
    RunOptions options;
    options.duration_s = 20;
    options.lockstep = true;
    options.record.path = file(name);
    testing::internal::CaptureStdout();
    auto summary = run_lockstep(rig, options);
    testing::internal::GetCapturedStdout();
    return summary;
  }
  static std::string file(const std::string& name) { return (folder_ / name).string(); }
  static RigReplayOptions quiet(const std::string& name) {
    RigReplayOptions options;
    options.recording = file(name);
    options.quiet = true;
    return options;
  }

  static inline fs::path folder_;
  static inline Summary summary_;
};

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
  RigRecorder recorder(rig, {file("faults.mcap")}, start, record::WhenBehind::wait);
  const std::vector<bus::Fault> faults{{"dvl", "silence", "says nothing", start, {}}};
  recorder.note(faults, start + std::chrono::seconds{1});
  recorder.note(std::span<const bus::Fault>{}, start + std::chrono::seconds{3});
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

TEST_F(ReplayOfARun, MeetsItsOwnReference) {
  auto options = quiet("run.mcap");
  options.update_refs = file("refs.json");
  ASSERT_EQ(replayed(options).exit_code, 0);
  options.update_refs.clear();
  options.check = file("refs.json");
  const auto checked = replayed(options);
  EXPECT_EQ(checked.exit_code, 0);
  EXPECT_NE(checked.err.find("has it: "), std::string::npos) << checked.err;
}

TEST_F(ReplayOfARun, SaysWhereItFirstDivergesFromAReference) {
  auto options = quiet("run.mcap");
  options.update_refs = file("refs.json");
  options.refs_every = 1;
  ASSERT_EQ(replayed(options).exit_code, 0);
  options = quiet("other-seed.mcap");
  options.check = file("refs.json");
  const auto checked = replayed(options);
  EXPECT_EQ(checked.exit_code, 1);
  EXPECT_NE(checked.err.find("first divergence: /imu/data at "), std::string::npos) << checked.err;
  EXPECT_NE(checked.err.find("(message 1): angular_velocity.x: expected "), std::string::npos)
      << checked.err;
}

TEST_F(ReplayOfARun, RefusesAReferenceOfAnotherPart) {
  auto options = quiet("run.mcap");
  options.update_refs = file("refs.json");
  ASSERT_EQ(replayed(options).exit_code, 0);
  options.update_refs.clear();
  options.check = file("refs.json");
  options.part.only = {"dvl"};
  EXPECT_EQ(replayed(options).exit_code, 2);
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

TEST_F(ReplayOfARun, LeavesNothingInTheTemporaryFolder) {
  auto recording = record::Recording::open(file("run.mcap")).value();
  fs::path folder;
  {
    const RecordedRig rig(recording);
    folder = rig.folder();
    EXPECT_TRUE(fs::exists(folder));
    EXPECT_EQ(rig.rig().mission.files.size() > 0 || rig.rig().files.size() > 1, true);
  }
  EXPECT_FALSE(fs::exists(folder));
}

TEST(RecordedRig, WithoutTheFilesOfItsWorldHasItsDriversAndSaysWhatIsMissing) {
  const fs::path path = fs::temp_directory_path() / ("rig-" + std::to_string(::getpid()));
  std::ifstream demo(DRYDOCK_SOURCE_DIR "/rig_config/rigs/demo.toml");
  record::RecorderOptions options;
  options.attachments = {{0, 0, "rig.toml", "", {std::istreambuf_iterator<char>(demo), {}}},
                         {0, 0, "../../../climbing.toml", "", "x = 1"}};
  record::Recorder(mcap::file_sink(path, true).value(), options).finish();
  auto recording = record::Recording::open(path).value();
  fs::remove(path);
  const RecordedRig rig(recording);
  EXPECT_EQ(rig.rig().devices.size(), 6u);
  EXPECT_TRUE(rig.rig().estimators.empty());
  EXPECT_NE(rig.trouble().find("s-path.toml"), std::string::npos) << rig.trouble();
  std::size_t inside = 0;
  for (const auto& entry : fs::recursive_directory_iterator(rig.folder()))
    inside += entry.path().filename() == "climbing.toml" ? 1U : 0U;
  EXPECT_EQ(inside, 1u) << "what climbs out of its folder stays in ours";
}

/// Times of a device's measurements of one type.
std::vector<double> times_of(const std::string& text, const std::string& device,
                             const std::string& type) {
  std::vector<double> times;
  for (const auto& line : lines_of(text))
    if (line.value("device", "") == device && line.value("type", "") == type)
      times.push_back(line["valid_at_s"]);
  return times;
}

class ReplayWithFaults : public ReplayOfARun {
 protected:
  static Replayed with(const std::string& faults, const std::string& only = "") {
    std::ofstream(file("faults.toml")) << faults;
    RigReplayOptions options;
    options.recording = file("run.mcap");
    options.faults = file("faults.toml");
    if (!only.empty()) options.part.only = {only};
    return replayed(options);
  }
  static Replayed sound() {
    RigReplayOptions options;
    options.recording = file("run.mcap");
    return replayed(options);
  }
};

TEST_F(ReplayWithFaults, ThatAreNoneIsTheReplayWithout) {
  EXPECT_EQ(with("fault = []\n").out, sound().out);
}

TEST_F(ReplayWithFaults, ThatNeverStrikeGivesEveryMeasurementAgainToTheLastDigit) {
  const auto replay = with(
      "[[fault]]\ndevice = \"dvl\"\nfault = \"drop\"\nprobability = 0.0\n"
      "[[fault]]\ndevice = \"gnss\"\nfault = \"flip\"\nprobability = 0.0\n"
      "[[fault]]\ndevice = \"imu\"\nfault = \"drop\"\nprobability = 0.0\n");
  EXPECT_EQ(replay.exit_code, 0) << replay.err;
  EXPECT_EQ(replay.out, sound().out);
}

TEST_F(ReplayWithFaults, LosesTheDroppedMeasurementsAndNoOther) {
  const auto replay = with("[[fault]]\ndevice = \"dvl\"\nfault = \"drop\"\nprobability = 0.3\n");
  ASSERT_EQ(replay.exit_code, 0) << replay.err;
  const auto all = sound();
  const auto before = times_of(all.out, "dvl", "bottom_velocity");
  const auto after = times_of(replay.out, "dvl", "bottom_velocity");
  ASSERT_GT(before.size(), 50u);
  EXPECT_TRUE(std::ranges::includes(before, after));
  EXPECT_NE(replay.err.find("dvl: faults hit drop " + std::to_string(before.size() - after.size()) +
                            "\n"),
            std::string::npos)
      << before.size() << " " << after.size() << replay.err;
  EXPECT_EQ(times_of(replay.out, "imu", "imu"), times_of(all.out, "imu", "imu"));
  EXPECT_EQ(with("[[fault]]\ndevice = \"dvl\"\nfault = \"drop\"\nprobability = 0.3\n").out,
            replay.out);
}

TEST_F(ReplayWithFaults, CountsWrongChecksumsWhereTheDriverDoes) {
  const auto replay = with(
      "[[fault]]\ndevice = \"dvl\"\nfault = \"bad-checksum\"\nprobability = 1.0\n"
      "start_s = 5.0\nfor_s = 2.0\n",
      "dvl");
  const auto all = times_of(sound().out, "dvl", "bottom_velocity").size();
  const auto got = times_of(replay.out, "dvl", "bottom_velocity").size();
  EXPECT_NE(replay.err.find(std::to_string(all - got) + " bad checksums"), std::string::npos)
      << replay.err;
  EXPECT_NE(replay.err.find("bad-checksum " + std::to_string(all - got)), std::string::npos);
  EXPECT_GT(got, 0u);
  EXPECT_LT(got, all);
}

TEST_F(ReplayWithFaults, AnUnpluggedPortIsLostAndComesBack) {
  const auto replay =
      with("[[fault]]\ndevice = \"dvl\"\nfault = \"unplug\"\nstart_s = 5.0\nfor_s = 2.0\n", "dvl");
  EXPECT_NE(replay.err.find("the port is gone"), std::string::npos) << replay.err;
  EXPECT_NE(replay.err.find("unplug 1"), std::string::npos) << replay.err;
  EXPECT_LT(times_of(replay.out, "dvl", "bottom_velocity").size(),
            times_of(sound().out, "dvl", "bottom_velocity").size());
}

TEST_F(ReplayWithFaults, RefusesWhatOnlyAnEmulatedSensorDoesAndWhatIsNotPlayed) {
  const auto off = with("[[fault]]\ndevice = \"dvl\"\nfault = \"bottom-lost\"\n");
  EXPECT_EQ(off.exit_code, 2);
  EXPECT_NE(off.err.find("faults.toml:1:1: /fault: dvl \"dvl\""), std::string::npos) << off.err;
  EXPECT_NE(off.err.find("behind the wire is a recording"), std::string::npos) << off.err;
  const auto unknown = with("[[fault]]\ndevice = \"dvk\"\nfault = \"drop\"\n");
  EXPECT_NE(unknown.err.find("no device is named \"dvk\""), std::string::npos) << unknown.err;
  const auto silent = with("[[fault]]\ndevice = \"dvl\"\nfault = \"drop\"\n", "imu");
  EXPECT_EQ(silent.exit_code, 2);
  EXPECT_NE(silent.err.find("does not play"), std::string::npos) << silent.err;
}

}  // namespace replay_test
