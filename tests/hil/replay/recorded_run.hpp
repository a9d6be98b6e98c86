#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "drivers/recordings/record/recording.hpp"
#include "hil/bench/run.hpp"
#include "hil/replay/replay_rig.hpp"
#include "rig_config/load.hpp"
#include "tests/drivers/decode/captured.hpp"

/// The demo rig runs in virtual time and is recorded. The recording is played through drivers and
/// estimators.
namespace recorded_run {

using namespace drydock;
using namespace drydock::replay;
namespace fs = std::filesystem;

/// All understood messages except truth and health, by topic: their bytes with their times.
inline std::map<std::string, std::vector<std::string>> results_of(const std::string& path) {
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

inline Replayed replayed(const RigReplayOptions& options, const std::string& typed = "") {
  decode::MemoryFile out, err;
  std::FILE* in = std::tmpfile();
  std::fputs(typed.c_str(), in);
  std::fflush(in);
  ::lseek(fileno(in), 0, SEEK_SET);
  const int code = replay_rig(options, in, out.file(), err.file());
  std::fclose(in);
  return {code, out.text(), err.text()};
}

inline std::vector<nlohmann::json> lines_of(const std::string& text) {
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

  static summary::Summary record(const std::string& name, std::uint64_t seed) {
    auto rig = rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/demo.toml").value();
    rig.seed = seed;
    bench::RunOptions options;
    options.duration_s = 20;
    options.lockstep = true;
    options.record.path = file(name);
    testing::internal::CaptureStdout();
    auto summary = bench::run_lockstep(rig, options);
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
  static inline summary::Summary summary_;
};

}  // namespace recorded_run
