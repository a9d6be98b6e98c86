// What `info` says of files whose content is known from the rig that made them, or from their text.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/hil/program/program.hpp"

namespace info_test {

using nlohmann::json;
using program::drydock;
using program::Folder;
using testing::HasSubstr;

/// The entry of a list with that name.
json named(const json& list, const std::string& name) {
  for (const auto& one : list)
    if (one["name"] == name) return one;
  return {};
}

class InfoOfARun : public testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(folder_ / "f.toml")
        << "[[fault]]\ndevice = \"emlog\"\nfault = \"hang\"\nstart_s = 8\nfor_s = 5\n";
    const auto run = drydock("run rig_config/rigs/demo.toml --for 20s --speed max --faults " +
                             (folder_ / "f.toml").string() + " --record " + dive_);
    ASSERT_EQ(run.exit_code, 0) << run.output;
  }
  Folder folder_;
  std::string dive_ = (folder_ / "dive.mcap").string();
};

TEST_F(InfoOfARun, HasTheRatesOfTheRigFileAndTheFault) {
  const auto said = drydock("info --json " + dive_);
  EXPECT_EQ(said.exit_code, 0);
  const auto info = json::parse(said.output);
  EXPECT_NEAR(info["duration_s"], 20, 0.1);
  EXPECT_EQ(info["begin"], "2026-11-21T08:00:00Z");
  const auto elsewhere = drydock("info --json " + dive_, "TZ=Asia/Kolkata");
  EXPECT_EQ(json::parse(elsewhere.output)["begin"], "2026-11-21T08:00:00Z");
  EXPECT_EQ(info["rig"], "demo");
  EXPECT_THAT(info["written_by"].get<std::string>(), testing::StartsWith("drydock "));
  EXPECT_NEAR(named(info["topics"], "/imu/data")["rate_hz"], 100, 0.5);
  EXPECT_NEAR(named(info["topics"], "/dvl/bottom_track")["rate_hz"], 5, 0.1);
  ASSERT_EQ(info["faults"].size(), 1u);
  EXPECT_NEAR(info["faults"][0]["since_s"], 8, 0.01);
  EXPECT_THAT(info["faults"][0]["fault"].get<std::string>(), HasSubstr("emlog: hang"));
  const auto log = named(info["links"], "pty:emlog?baud=4800");
  EXPECT_NEAR(log["longest_gap_s"], 5.5, 0.5) << "it hung for 5 s between readings of 2 Hz";
  EXPECT_NEAR(log["longest_gap_at_s"], 8, 0.6);
  EXPECT_EQ(info["devices"]["pty:dvl?baud=115200"], json::array({"dvl"}));
}

TEST_F(InfoOfARun, SaysTheSameInWords) {
  const auto said = drydock("info " + dive_).output;
  EXPECT_THAT(said, HasSubstr("MCAP recording"));
  EXPECT_THAT(said, HasSubstr("link pty:dvl?baud=115200: dvl\n"));
  EXPECT_THAT(said, HasSubstr("fault at 8.0 s: emlog: hang"));
}

TEST_F(InfoOfARun, SaysWhereACutOneIsDamagedAndIsOne) {
  std::filesystem::resize_file(dive_, std::filesystem::file_size(dive_) / 2);
  const auto said = drydock("info " + dive_);
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_THAT(said.output, HasSubstr("damaged: "));
}

TEST_F(InfoOfARun, AndTopicEchoesTheMessagesOfADevice) {
  const auto said = drydock("topic " + dive_ + " dvl");
  EXPECT_EQ(said.exit_code, 0);
  std::istringstream lines(said.output);
  std::string line;
  std::size_t tracks = 0;
  while (std::getline(lines, line)) tracks += json::parse(line)["topic"] == "/dvl/bottom_track";
  EXPECT_NEAR(static_cast<double>(tracks), 100, 3) << "5 Hz for 20 s";
  EXPECT_EQ(drydock("topic " + dive_ + " /imu/data --count 3 | wc -l").output, "3\n");
  const auto none = drydock("topic " + dive_ + " sonar");
  EXPECT_EQ(none.exit_code, 1);
  EXPECT_THAT(none.output, HasSubstr("/dvl/bottom_track"));
}

TEST(Topic, OfARunningRigComesFromTheBus) {
  const auto said =
      drydock(program::emulated_demo +
              "drive rig_config/rigs/demo.toml --for 10s >/dev/null & sleep 2; " DRYDOCK_PROGRAM
              " topic rig_config/rigs/demo.toml imu --count 5; "
              "true");
  std::istringstream lines(said.output);
  std::string line;
  int messages = 0;
  while (std::getline(lines, line)) {
    const auto message = json::parse(line, nullptr, false);
    messages += message.contains("device") && message["device"] == "imu" &&
                std::abs(message["specific_force_mps2"][2].get<double>() + 9.8) < 1;
  }
  EXPECT_EQ(messages, 5) << said.output;
}

TEST(Topic, WithoutARigSaysWhatToDo) {
  const auto said = drydock("topic /imu/data");
  EXPECT_NE(said.exit_code, 0);
  EXPECT_THAT(said.output, HasSubstr("/imu/data is a topic: of which rig, or of which recording?"));
  EXPECT_THAT(said.output, HasSubstr("drydock topic my-rig.toml /imu/data"));
}

TEST(Topic, OfARunningRigHasItsEstimatesAndDiagnosticsToo) {
  const std::string topic = DRYDOCK_PROGRAM " topic rig_config/rigs/demo.toml ";
  const auto said =
      drydock("run rig_config/rigs/demo.toml --for 12s >/dev/null 2>&1 & sleep 2; " + topic +
              "/estimate/leveling --count 1; " + topic + "diagnostics --count 1; wait; true");
  EXPECT_THAT(said.output, HasSubstr("{\"estimator\":\"leveling\",\"type\":\"attitude\""));
  EXPECT_THAT(said.output, HasSubstr("{\"type\":\"diagnostics\",\"name\":\""));
}

TEST(Info, OfACandumpLogHasItsFramesInterfacesAndGap) {
  const Folder folder;
  std::ofstream(folder / "t.log") << "(1700000000.000000) can0 123#11\n"
                                     "(1700000000.500000) can1 124#22\n"
                                     "(1700000003.000000) can0 123#33\n";
  const auto info = json::parse(drydock("info --json " + (folder / "t.log").string()).output);
  EXPECT_EQ(info["format"], "candump-log");
  EXPECT_EQ(info["frames"], 3);
  EXPECT_EQ(info["identifiers"], 2);
  EXPECT_EQ(info["interfaces"], (json{{"can0", 2}, {"can1", 1}}));
  EXPECT_DOUBLE_EQ(info["duration_s"], 3.0);
  EXPECT_DOUBLE_EQ(info["longest_gap_s"], 2.5);
}

TEST(Info, OfACaptureWithDatesSaysWhenItBegan) {
  const Folder folder;
  std::ofstream(folder / "t.log") << "(1700000000.000000) can0 123#11\n";
  const auto said = drydock("info " + (folder / "t.log").string());
  EXPECT_THAT(said.output, HasSubstr("from 2023-11-14T22:13:20Z"));  // by `date -u -d @1700000000`
  std::ofstream(folder / "own.log") << "(1.000000) can0 123#11\n";   // counts from its own start
  EXPECT_THAT(drydock("info " + (folder / "own.log").string()).output,
              testing::Not(HasSubstr("from ")));
}

TEST(Info, AClockThatWasSetIsNoGap) {
  const Folder folder;
  std::ofstream(folder / "t.log") << "(1700000000.000000) can0 123#11\n"
                                     "(1699990000.000000) can0 123#22\n"
                                     "(1699990000.500000) can0 123#22\n"
                                     "(1700000001.000000) can0 123#33\n";
  const auto said = drydock("info " + (folder / "t.log").string()).output;
  EXPECT_THAT(said, HasSubstr("longest gap 0.500 s"));
  EXPECT_THAT(said, HasSubstr("the clock went back: 2 frames have times before an earlier frame's, "
                              "by up to 10000.000 s"));
}

TEST(Info, OfPacketsOfSerialLinesNamesTheProtocolOfEach) {
  const auto said = drydock("info fixtures/install/two-lines.pcapng");
  EXPECT_THAT(said.output, HasSubstr("line log: 6 reads, 99 bytes, 2.0 s, from "));
  EXPECT_THAT(said.output,
              HasSubstr("other: nmea0183 (likely): 3 good frames, 0 bad; 100 % of 102 bytes"));
}

/// `$GPHDT,75.5664,T*36` is the example of a manual.
TEST(Info, OfSentencesWithALoggersTimesDoesNotSayThatTheyHaveNone) {
  const Folder folder;
  std::ofstream log(folder / "t.log");
  for (const char* second : {"00", "01", "02", "03"})
    log << "10/13/2014,00:00:" << second << ".123,$GPHDT,75.5664,T*36\r\n";
  log.close();
  const auto said = drydock("info " + (folder / "t.log").string()).output;
  EXPECT_THAT(said, HasSubstr("t.log: 180 bytes of a line\n"));
  EXPECT_THAT(said, HasSubstr("are their times"));
}

TEST(Info, OfSeveralFilesHasABlockForEachAndATotal) {
  const Folder folder;
  std::ofstream(folder / "t.0.log") << "(1700000000.000000) can0 123#11\n"
                                       "(1700000001.000000) can0 123#22\n";
  std::ofstream(folder / "t.1.log") << "(1700000002.000000) can0 123#11\n"
                                       "(1700000004.500000) can0 124#22\n"
                                       "(1700000005.000000) can0 124#22\n";
  const auto said = drydock("info " + (folder / "t.*.log").string());
  EXPECT_EQ(said.exit_code, 0);
  EXPECT_THAT(said.output, HasSubstr("t.0.log: CAN capture, candump-log, 64 B, 2 frames"));
  EXPECT_THAT(said.output, HasSubstr("t.1.log: CAN capture, candump-log, 96 B, 3 frames"));
  EXPECT_THAT(said.output,
              HasSubstr("total: 2 files, 160 B, 5 frames, 5.0 s, from 2023-11-14T22:13:20Z\n"));
  const auto all = json::parse(drydock("info --json " + (folder / "t.*.log").string()).output);
  ASSERT_EQ(all["files"].size(), 2u);
  EXPECT_EQ(all["files"][1]["frames"], 3);
  EXPECT_EQ(all["total"]["frames"], 5);
  EXPECT_EQ(all["total"]["duration_s"], 5.0);
}

TEST(Info, OfSeveralFilesGoesOnBehindOneThatIsNotThere) {
  const auto said = drydock("info fixtures/nowhere.pd0 fixtures/pd0/golden.pd0");
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_THAT(said.output, HasSubstr("nowhere.pd0"));
  EXPECT_THAT(said.output, HasSubstr("total: 1 files"));
}

TEST(Info, OfPacketsThatEndInOneSaysHowMuchIsLeft) {
  const Folder folder;
  const auto cut = folder / "cut.pcapng";
  std::filesystem::copy_file(DRYDOCK_SOURCE_DIR "/fixtures/install/two-lines.pcapng", cut);
  std::filesystem::resize_file(cut, std::filesystem::file_size(cut) - 7);
  const auto said = drydock("info " + cut.string());
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_THAT(said.output, HasSubstr("cut.pcapng ends inside of a packet: "));
  EXPECT_THAT(drydock("probe file:" + cut.string() + "?interface=log").output,
              HasSubstr("cut.pcapng ends inside of a packet: "));
}

/// ASAM's MDF 4.1, the identification block: 8 bytes of the file's kind, 8 of its version.
TEST(Info, OfMeasurementDataSaysWhatToDoWithItsChannels) {
  const Folder folder;
  std::ofstream(folder / "dive.mf4") << "MDF     4.10    " << std::string(200, ' ');
  const auto said = drydock("info " + (folder / "dive.mf4").string());
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_THAT(said.output, HasSubstr("it is ASAM's MF4, which is not read: export asc"));
  EXPECT_THAT(said.output, testing::Not(HasSubstr("bytes of a line")));
}

TEST(Info, OfBytesNamesTheProtocol) {
  const auto said = drydock("info fixtures/pd0/golden.pd0");
  EXPECT_EQ(said.exit_code, 0);
  EXPECT_THAT(said.output, HasSubstr("pd0"));
}

}  // namespace info_test
