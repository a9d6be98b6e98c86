#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "hil/bench/run.hpp"
#include "rig_config/load.hpp"

/// A rig with one IMU on a straight path, and an estimator that is a Python program of a few lines.
namespace outside_rig {

namespace drydock = ::drydock;

/// A temporary folder; the destructor removes it.
class Folder {
 public:
  Folder() {
    path_ = testing::TempDir() + "drydock-outside-XXXXXX";
    if (mkdtemp(path_.data()) == nullptr) path_.clear();
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string operator/(const std::string& file) const { return path_ + "/" + file; }

 private:
  std::string path_;
};

/// The straight path of this mission begins at 36 N 129 E, 10 m deep, and goes north at 10 m/s.
inline const std::string one_imu = R"(
[rig]
name = "outside"
start = 2026-11-21T08:00:00Z
mission = ")" DRYDOCK_SOURCE_DIR R"(/rig_config/missions/leveling-straight.toml"
[[device]]
name = "imu"
kind = "imu"
protocol = "cia404-imu"
link = "can:auto?name=outside0&bitrate=250000"
rate_hz = 100
address = 1
)";

inline std::string estimator(const std::string& gives, const std::string& more = {},
                             const std::string& command = R"(["python3", "client.py"])") {
  return "[[estimator]]\nname = \"mine\"\nkind = \"external\"\nimu = \"imu\"\ngives = \"" + gives +
         "\"\ncommand = " + command + "\n" + more + "\n";
}

/// A client whose `estimate(sample)` gives what follows "valid_at_ns", and whose `answer(step,
/// said)` says the answer.
inline std::string client(const std::string& estimate, const std::string& answer = "say(said)") {
  return "import json, os, sys, time\n"
         "def say(said): print(json.dumps(said), flush=True)\n"
         "hello = json.loads(sys.stdin.readline())\n"
         "say({'drydock': 1})\n"
         "start = None\n"
         "def estimate(m):\n"
         "    t = (m['valid_at_ns'] - start) / 1e9\n"
         "    return {'valid_at_ns': m['valid_at_ns'], **" +
         estimate +
         "}\n"
         "for line in sys.stdin:\n"
         "    step = json.loads(line)\n"
         "    n = step['step']\n"
         "    start = start or step['measurements'][0]['valid_at_ns']\n"
         "    said = {'step': n, 'estimates': [estimate(m) for m in step['measurements']]}\n"
         "    " +
         answer + "\n";
}

inline drydock::summary::Summary run(const Folder& folder, const std::string& rig_text,
                                     const std::string& client_text, double seconds,
                                     std::string* said = nullptr) {
  std::ofstream(folder / "client.py") << client_text;
  std::ofstream(folder / "rig.toml") << rig_text;
  testing::internal::CaptureStdout();
  drydock::bench::RunOptions options;
  options.duration_s = seconds;
  const auto rig = drydock::rig_config::load_rig(folder / "rig.toml").value();
  auto summary = drydock::bench::run_lockstep(rig, options);
  const auto out = testing::internal::GetCapturedStdout();
  if (said != nullptr) *said = out;
  return summary;
}

}  // namespace outside_rig
