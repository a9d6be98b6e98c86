// Several devices on one line or in one file: recorded once, replayed as it was.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <fstream>

#include "hil/replay/rigs/recorded_rig.hpp"
#include "tests/hil/replay/recorded_run.hpp"

namespace shared_links_test {

using namespace recorded_run;
using testing::IsEmpty;

std::string sentence(const std::string& body) {
  unsigned sum = 0;
  for (const char c : body) sum ^= static_cast<unsigned char>(c);
  return fmt::format("${}*{:02X}\r\n", body, sum);
}

/// Two minutes of a ship's line: a fix, a heading and a speed each second. It goes north at 2 m/s.
std::string ships_line() {
  std::string text;
  for (int t = 0; t < 120; ++t) {
    const auto time = fmt::format("12{:02}{:02}.00", t / 60, t % 60);
    const auto place = fmt::format("{:.6f},N,07042.000000,W", 4130 + 0.00108 * t);
    text += sentence("GPRMC," + time + ",A," + place + ",3.888,0.0,280224,,,A") +
            sentence("HEHDT,0.0,T") + sentence("VDVBW,3.888,0.0,A,3.888,0.0,A,,V,,V") +
            sentence("GPGGA," + time + "," + place + ",4,10,0.9,0.0,M,0.0,M,,");
  }
  return text;
}

std::string device_on(const std::string& link, const std::string& kind) {
  return fmt::format(
      "[[device]]\nname = \"{0}\"\nkind = \"{0}\"\nprotocol = \"nmea0183\"\nlink = \"{1}\"\n"
      "rate_hz = 1\n",
      kind, link);
}

class SharedLinks : public testing::Test {
 protected:
  SharedLinks() { fs::create_directories(folder_); }
  ~SharedLinks() override { fs::remove_all(folder_); }

  std::string file(const std::string& name) const { return (folder_ / name).string(); }

  rig_config::Rig rig_on(const std::string& link, const std::string& mission = "") const {
    std::ofstream(file("rig.toml")) << "[rig]\nname = \"ship\"\n"
                                    << mission << device_on(link, "gnss")
                                    << device_on(link, "attitude") << device_on(link, "emlog");
    return rig_config::load_rig(file("rig.toml")).value();
  }

  summary::Summary run(const rig_config::Rig& rig, double duration_s = 0) const {
    bench::RunOptions options;
    options.duration_s = duration_s;
    options.lockstep = true;
    options.record = {file("run.mcap"), true};
    testing::internal::CaptureStdout();
    auto summary = bench::run_lockstep(rig, options);
    testing::internal::GetCapturedStdout();
    return summary;
  }

  std::map<std::string, std::vector<std::string>> replayed_results() const {
    RigReplayOptions options;
    options.recording = file("run.mcap");
    options.quiet = true;
    options.record = {file("replay.mcap"), true};
    EXPECT_EQ(replayed(options).exit_code, 0);
    return results_of(file("replay.mcap"));
  }

  static std::string received_bytes(const std::string& path) {
    std::string all;
    auto recording = record::Recording::open(path).value();
    EXPECT_EQ(recording.links().size(), 1u);
    while (const auto event = recording.next()) {
      const auto* raw = std::get_if<record::RawEvent>(&*event);
      if (raw == nullptr || raw->direction() != record::Direction::received) continue;
      const auto& bytes = std::get<record::RawBytes>(raw->content).data;
      all.append(bytes.begin(), bytes.end());
    }
    return all;
  }

  const fs::path folder_ =
      fs::temp_directory_path() / ("shared-links-" + std::to_string(::getpid()));
};

TEST_F(SharedLinks, AFileOfSeveralDevicesIsPlayedToItsEndAndRecordedOnce) {
  std::ofstream(file("ship.nmea")) << ships_line();
  const auto summary = run(rig_on("file:ship.nmea"));
  EXPECT_NEAR(summary.duration_s, 120, 2) << "without a duration the files tell it";
  EXPECT_THAT(summary.findings, IsEmpty());
  for (const auto& device : summary.devices) {
    EXPECT_EQ(device.state, "streaming") << device.name;
    EXPECT_GE(device.messages, 119u) << device.name;
  }
  EXPECT_EQ(received_bytes(file("run.mcap")), ships_line());
  EXPECT_EQ(replayed_results(), results_of(file("run.mcap")));
  EXPECT_EQ(received_bytes(file("replay.mcap")), ships_line());
}

TEST_F(SharedLinks, TheEndOfAFileIsNoFault) {
  std::ofstream(file("ship.nmea")) << ships_line();
  const auto summary = run(rig_on("file:ship.nmea"), 200);
  EXPECT_NEAR(summary.duration_s, 200, 1e-6);
  EXPECT_THAT(summary.findings, IsEmpty());
  for (const auto& device : summary.devices) EXPECT_EQ(device.state, "closed") << device.name;
}

TEST_F(SharedLinks, ARecordedRigNamesItsFileAsTheRunDid) {
  std::ofstream(file("ship.nmea")) << ships_line();
  const auto rig = rig_on("file:ship.nmea");
  run(rig);
  const RecordedRig recorded(record::Recording::open(file("run.mcap")).value());
  for (std::size_t i = 0; i < rig.devices.size(); ++i)
    EXPECT_EQ(recorded.rig().devices[i].link, rig.devices[i].link);
}

TEST_F(SharedLinks, AnEmulatedLineOfSeveralDevicesIsRecordedOnceAndReplayedAsItWas) {
  const std::string mission =
      "mission = \"" DRYDOCK_SOURCE_DIR "/rig_config/missions/s-path.toml\"\n";
  const auto summary = run(rig_on("pty:ship?baud=4800", mission), 20);
  EXPECT_THAT(summary.findings, IsEmpty());
  for (const auto& device : summary.devices) {
    EXPECT_EQ(device.state, "streaming") << device.name;
    EXPECT_GE(device.messages, 18u) << device.name;
    EXPECT_EQ(device.bytes_skipped, 0u) << device.name;
  }
  const auto bytes = received_bytes(file("run.mcap"));
  EXPECT_LE(bytes.size(), 480u * 20u) << "more than the line carries";
  EXPECT_EQ(replayed_results(), results_of(file("run.mcap")));
}

}  // namespace shared_links_test
