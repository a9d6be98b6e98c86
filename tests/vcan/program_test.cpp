// The program on a SocketCAN interface, with can-utils at the other end of the bus.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/vcan/process.hpp"

namespace drydock::vcan {
namespace {

using ::testing::HasSubstr;

const std::string dives = DRYDOCK_SOURCE_DIR "/fixtures/dives/";

/// `ID#DATA` from the lines of a candump log, in order. If `way` is not "", only lines that end
/// with it.
std::vector<std::string> frames_of(std::istream&& log, const std::string& way = "") {
  std::vector<std::string> frames;
  for (std::string line; std::getline(log, line);) {
    std::istringstream words(line);
    std::string time, interface, frame;
    if (words >> time >> interface >> frame && time.front() == '(' && line.ends_with(way))
      frames.push_back(frame);
  }
  return frames;
}

class ProgramOnVcan : public ::testing::Test {
 protected:
  ProgramOnVcan() {
    auto name = (std::filesystem::temp_directory_path() / "drydock-vcan-XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
  }
  ~ProgramOnVcan() override { std::filesystem::remove_all(folder_); }

  std::string file(const std::string& name) const { return folder_ / name; }

  /// The data that the links of a recording received, from `drydock export`.
  std::vector<std::string> received_in(const std::string& recording) const {
    EXPECT_EQ(run_program({DRYDOCK_PROGRAM, "export", recording, "--to", "candump", "--direction",
                           "--overwrite", "-o", file("export.log")}),
              0);
    return frames_of(std::ifstream(file("export.log")), " R");
  }

  static std::vector<std::string> replay_onto_the_bus(const std::string& dive,
                                                      const std::string& speed) {
    return {DRYDOCK_PROGRAM, "replay", dives + dive + "/dive.mcap",
            "--quiet",       "--onto", "drydock0=socketcan:" + interface(),
            "--speed",       speed};
  }

  std::filesystem::path folder_;
};

TEST_F(ProgramOnVcan, ReplayOntoItIsHeardByCandumpFrameByFrame) {
  const auto expected = received_in(dives + "imu-is-set-up/dive.mcap");
  ASSERT_GT(expected.size(), 300u);
  const int before = receiver_count(interface());
  Process candump({"candump", "-L", "-n", std::to_string(expected.size()), interface()});
  ASSERT_TRUE(wait_for_receivers(interface(), before + 1));
  Process replay(replay_onto_the_bus("imu-is-set-up", "5"));
  EXPECT_EQ(replay.wait(), 0);
  const auto heard = candump.output_until(expected.back());
  EXPECT_EQ(frames_of(std::istringstream(heard)), expected);
}

TEST_F(ProgramOnVcan, ProbeNamesTheSensorOfAReplay) {
  Process replay(replay_onto_the_bus("rudder-swings", "2"));
  Process probe({DRYDOCK_PROGRAM, "probe", "socketcan:" + interface(), "--for", "8s", "--json"});
  // Its whole output is one object, at its end.
  std::string said;
  for (int tries = 0; tries < 6 && said.find("\n") == std::string::npos; ++tries)
    said = probe.output_until("\n");
  EXPECT_EQ(probe.wait(), 0);
  const auto found = nlohmann::json::parse(said);
  EXPECT_EQ(found["confidence"], "certain");
  ASSERT_EQ(found["devices"].size(), 1u) << said;
  EXPECT_EQ(found["devices"][0]["kind"], "actuator");
  EXPECT_EQ(found["devices"][0]["protocol"], "nmea2000");
  EXPECT_EQ(found["devices"][0]["address"], 36);
}

TEST_F(ProgramOnVcan, ARecordingHoldsWhatCanplayerSent) {
  const auto sent = received_in(dives + "rudder-swings/dive.mcap");
  ASSERT_GT(sent.size(), 100u);
  std::ofstream(file("rig.toml"))
      << "[rig]\nname = \"vcan\"\npublish = false\n[[device]]\nname = \"actuators\"\n"
         "kind = \"actuator\"\nprotocol = \"nmea2000\"\nrate_hz = 2\nstale_after_s = 60\nlink = "
         "\"socketcan:"
      << interface() << "\"\n";
  std::ofstream log(file("sent.log"));
  for (const auto& frame : sent) log << "(1.000000) bus " << frame << '\n';
  log.close();

  const int before = receiver_count(interface());
  Process record(
      {DRYDOCK_PROGRAM, "record", file("rig.toml"), "-o", file("dive.mcap"), "--for", "8s"});
  ASSERT_TRUE(wait_for_receivers(interface(), before + 1));
  ASSERT_EQ(run_program({"canplayer", "-t", "-I", file("sent.log"), interface() + "=bus"}), 0);
  EXPECT_EQ(record.wait(), 0);
  EXPECT_THAT(record.output_until("lost"), HasSubstr("184 messages, 0 bytes skipped"));
  EXPECT_EQ(received_in(file("dive.mcap")), sent);
}

}  // namespace
}  // namespace drydock::vcan
