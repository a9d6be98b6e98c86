// Serial lines in a pcapng file: those of fixtures/install, which its script made from the
// documented layouts, and those that `export` writes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/hil/program/program.hpp"

namespace serial_pcapng_test {

using nlohmann::json;
using program::drydock;
using program::Folder;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* one = "fixtures/install/serial.pcapng";
constexpr const char* two = "fixtures/install/two-lines.pcapng";

/// The values of a key in the JSON lines that have it.
std::vector<double> values(const std::string& lines, const std::string& key) {
  std::vector<double> all;
  std::istringstream in(lines);
  for (std::string line; std::getline(in, line);)
    if (const auto object = json::parse(line, nullptr, false); object.contains(key))
      all.push_back(object[key]);
  return all;
}

TEST(SerialPcapng, IsDecodedWithoutItsContainerAndWithoutWhatTheComputerSent) {
  const auto decoded = drydock(std::string("decode --protocol nmea0183 ") + one);
  EXPECT_EQ(decoded.exit_code, 0);
  EXPECT_THAT(decoded.output, HasSubstr("5 frames, 5 messages, 0 bad checksums, 0 bytes skipped"));
}

TEST(SerialPcapng, IsReplayedAtItsOwnTimes) {
  const auto played =
      drydock(std::string("replay --quiet --protocol nmea0183 --kind emlog --baud 4800 ") + one);
  EXPECT_EQ(played.exit_code, 0) << played.output;
  const auto received = values(played.output, "received_at_s");
  ASSERT_EQ(received.size(), 5u) << played.output;
  for (std::size_t i = 0; i < received.size(); ++i)
    EXPECT_NEAR(received[i], 1.7e9 + 2 * static_cast<double>(i) + 0.01, 1e-6);
}

TEST(SerialPcapng, OfSeveralLinesNeedsAChoice) {
  const std::string decode = std::string("decode --protocol nmea0183 ") + two;
  const auto asked = drydock(decode);
  EXPECT_EQ(asked.exit_code, 1);
  EXPECT_THAT(asked.output, HasSubstr("several serial lines: log, other; --interface chooses one"));
  EXPECT_THAT(drydock(decode + " --interface log").output, HasSubstr("3 frames, 3 messages"));
  EXPECT_THAT(drydock(decode + " --interface third").output,
              HasSubstr("has no serial line third; it has log, other"));
}

TEST(SerialPcapng, IsToldByInfo) {
  const auto info = json::parse(drydock(std::string("info --json ") + one).output);
  ASSERT_EQ(info["lines"].size(), 1u);
  EXPECT_EQ(info["lines"][0]["reads"], 10);
  EXPECT_NEAR(info["lines"][0]["duration_s"], 8.01, 1e-6);
  EXPECT_THAT(drydock(std::string("info ") + two).output, HasSubstr("2 serial lines"));
}

TEST(SerialPcapng, OfSeveralLinesInARigNeedsAChoiceToo) {
  const Folder folder;
  std::ofstream(folder / "rig.toml") << "[rig]\nname = \"two\"\n[[device]]\nname = \"log\"\n"
                                        "kind = \"emlog\"\nprotocol = \"nmea0183\"\n"
                                        "link = \"file:" DRYDOCK_SOURCE_DIR "/"
                                     << two << "\"\n";
  const auto said = drydock("run --speed max --for 3s " + (folder / "rig.toml").string());
  EXPECT_NE(said.exit_code, 0);
  EXPECT_THAT(said.output, HasSubstr("several serial lines: log, other; --interface chooses one, "
                                     "in a link interface="));
}

TEST(SerialPcapng, IsProbedLineByLineWithARigBlockForEach) {
  const auto probed = drydock(std::string("probe file:") + two + "?speed=max");
  EXPECT_EQ(probed.exit_code, 0);
  EXPECT_THAT(probed.output,
              HasSubstr("log: nmea0183 (likely): 3 good frames, 0 bad; 100 % of 99"));
  EXPECT_THAT(probed.output,
              HasSubstr("other: nmea0183 (likely): 3 good frames, 0 bad; 100 % of 102"));
  const Folder folder;
  auto blocks = probed.output.substr(probed.output.find("[[device]]"));
  for (auto at = blocks.find("file:f"); at != std::string::npos; at = blocks.find("file:f", at))
    blocks.insert(at + 5, DRYDOCK_SOURCE_DIR "/");
  std::ofstream(folder / "rig.toml") << "[rig]\nname = \"two\"\n" << blocks;
  const auto run = drydock("run --speed max --for 5s " + (folder / "rig.toml").string());
  EXPECT_EQ(run.exit_code, 0) << run.output;
}

/// A pcap file (link type 101, raw IP; microseconds) in which each sender says one sentence by UDP.
std::string whole_network(int senders) {
  const std::string sentence = "$GPHDT,75.5664,T*36\r\n";
  const auto little = [](std::uint32_t value) {
    return std::string{static_cast<char>(value), static_cast<char>(value >> 8),
                       static_cast<char>(value >> 16), static_cast<char>(value >> 24)};
  };
  std::string file =
      little(0xA1B2C3D4) + little(0x00040002) + little(0) + little(0) + little(65535) + little(101);
  for (int i = 0; i < senders; ++i) {
    const auto size = static_cast<char>(28 + sentence.size());
    const std::string ip = {0x45, 0,
                            0,    size,
                            0,    0,
                            0,    0,
                            64,   17,
                            0,    0,
                            10,   0,
                            0,    static_cast<char>(i),
                            10,   0,
                            1,    1,
                            39,   16,
                            39,   17,
                            0,    static_cast<char>(size - 20),
                            0,    0};
    const auto length = static_cast<std::uint32_t>(size);
    file += little(1'700'000'000) + little(static_cast<std::uint32_t>(1000 * i)) + little(length) +
            little(length) + ip + sentence;
  }
  return file;
}

TEST(WholeNetwork, IsProbedWhereMostWasSaidAndTheRestIsCounted) {
  const Folder folder;
  const std::string file = (folder / "all.pcap").string();
  std::ofstream(file, std::ios::binary) << whole_network(40);
  const auto probed = drydock("probe " + file);
  EXPECT_THAT(probed.output, HasSubstr("24 lines with fewer bytes were not looked at"));
  EXPECT_THAT(probed.output, HasSubstr("10.0.0.3:10000: nmea0183"));
  EXPECT_THAT(drydock("info " + file).output, HasSubstr("line 10.0.0.39:10000: 1 reads, 21 bytes"));
  EXPECT_THAT(drydock("decode --protocol nmea0183 " + file).output,
              HasSubstr("10.0.0.15:10000 and 24 more (drydock info); --interface chooses one"));
}

/// A recording of the demo rig, as one file of packets with a CAN bus and three serial lines.
class MixedPackets : public testing::Test {
 protected:
  void SetUp() override {
    const std::string dive = (folder_ / "d.mcap").string();
    ASSERT_EQ(
        drydock("run rig_config/rigs/demo.toml --for 20s --speed max --record " + dive).exit_code,
        0);
    ASSERT_EQ(drydock("export " + dive + " --to pcapng -o " + packets()).exit_code, 0);
  }
  std::string packets() const { return (folder_ / "d.pcapng").string(); }
  Folder folder_;
};

TEST_F(MixedPackets, AreProbedAndToldWithBusAndLines) {
  for (const auto& said : {drydock("probe " + packets()), drydock("info " + packets())}) {
    EXPECT_EQ(said.exit_code, 0);
    EXPECT_THAT(said.output, HasSubstr("CANopen node 1"));
    EXPECT_THAT(said.output, HasSubstr("dvl: pd0 (certain)"));
    EXPECT_THAT(said.output, HasSubstr("emlog: nmea0183 ("));
    EXPECT_THAT(said.output, HasSubstr("gnss: ubx ("));
  }
  EXPECT_EQ(json::parse(drydock("info --json " + packets()).output)["lines"].size(), 3u);
}

TEST_F(MixedPackets, AreDiagnosedWithAllDevicesBesideEachOther) {
  const auto said = drydock("diagnose " + packets());
  EXPECT_THAT(said.output, HasSubstr("20.0 s, 6 of 6 devices heard"));
  EXPECT_THAT(said.output, HasSubstr("a capture tells no mountings"));  // the DVL stands at 45 deg
}

TEST_F(MixedPackets, PlayInRealTimeAtTheirOwnTimes) {
  const auto seen = drydock("monitor 'file:" + packets() + "?interface=dvl' --once");
  EXPECT_EQ(seen.exit_code, 0) << seen.output;
  EXPECT_THAT(seen.output, HasSubstr("dvl        streaming"));
}

TEST(SerialPcapng, OfAnExportGivesTheMeasurementsOfTheRecording) {
  const Folder folder;
  const std::string dive = (folder / "d.mcap").string(), packets = (folder / "d.pcapng").string();
  ASSERT_EQ(
      drydock("run rig_config/rigs/demo.toml --for 20s --speed max --record " + dive).exit_code, 0);
  ASSERT_EQ(drydock("export " + dive + " --only dvl --to pcapng -o " + packets).exit_code, 0);
  const auto then = drydock("replay --only dvl " + dive + " 2>/dev/null #").output;
  const auto now =
      drydock("replay --protocol pd0 --interface dvl --baud 115200 " + packets + " 2>/dev/null #")
          .output;
  const auto before = values(then, "received_at_s");
  EXPECT_GT(before.size(), 50u);
  EXPECT_EQ(values(now, "received_at_s").size(), before.size());
}

}  // namespace serial_pcapng_test
