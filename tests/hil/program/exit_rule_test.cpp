// One rule of exit codes and signals, tried on every command: docs/use/run.md has it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <vector>

#include "tests/hil/program/running.hpp"

namespace exit_rule_test {

using program::drydock;
using program::Folder;
using program::Running;
using testing::HasSubstr;

#define DEMO "rig_config/rigs/demo.toml"
#define DIVE "fixtures/dives/dvl-finds-the-bottom/dive.mcap"

struct Row {
  std::string command;
  std::string prints;  ///< soon over, with something on standard output; empty: it prints none
  std::string lasts;   ///< works for minutes; empty: no such work
  std::string says;    ///< what a line of the lasting one begins with, when it is at work
};

/// Every command. @ stands for a folder of the test's own.
const std::vector<Row>& rows() {
  static const std::vector<Row> all{
      {"run", DEMO " --for 1s --speed max", DEMO " --for 100h --speed max", "streaming"},
      {"emulate", "", DEMO " --for 1h", "imu: "},
      {"drive", "", DEMO " --for 1h", ""},
      {"record", "", DEMO " --for 1h -o @/r.mcap", ""},
      {"estimate", "", DEMO " --for 1h", ""},
      {"check", DEMO, "", ""},
      {"fault", DEMO " words", "", ""},
      {"diagnose", DIVE, DEMO " --for 1h", ""},
      {"decode", "fixtures/pd0/golden.pd0 --protocol pd0", "@/pipe --protocol pd0", ""},
      {"probe", "--all", "serial:@/port --for 1h", ""},
      {"describe", "fixtures/pd0/golden.pd0", "", ""},
      {"monitor", "", DEMO " --for 1h --json", "{"},
      {"doctor", " ", "", ""},
      {"completion", "bash", "", ""},
      {"man", " ", "", ""},
      {"help", "run", "", ""},
      {"topic", "fixtures/recording/before-accuracies.mcap", DEMO " --for 1h", ""},
      {"example", " ", "", ""},
      {"new", "", "", ""},
      {"info", DIVE, "", ""},
      {"export", DIVE " --to pcapng -o -", "", ""},
      {"recover", "", "", ""},
      {"cut", "", "", ""},
      {"bisect", "", "", ""},
      {"replay", DIVE, DIVE " --speed 0.01", ""},
      {"diff", DIVE " " DIVE, "", ""},
      {"track", "", "", ""},
      {"twin", "", "", ""},
      {"proxy", "", "pty:@/a pty:@/b --for 1h", ""},
      {"bridge", "", "mavlink " DEMO " --to udp:127.0.0.1:14559 --for 1h", "udp:"},
      {"sensor", "rig_config/sensors/xsens-mti-630.toml --for 20s",
       "rig_config/sensors/xsens-mti-630.toml --for 5000h", ""},
      {"sky", "--ephemeris fixtures/rinex/walker.rnx --at 2026-11-21T09:00:00Z", "", ""},
      {"maneuver", "rig_config/vehicles/nps-auv-ii.toml turning-circle", "", ""},
      {"study", "mixing --runs 1", "leveling --runs 100000", ""},
      {"campaign", "", "", ""},
      {"calibrate", "", "", ""},
      {"characterize", "", DEMO " --device imu --for 1h", ""},
      {"soak", "rig_config/rigs/soak.toml --for 10min", "rig_config/rigs/soak.toml", ""},
      {"validity", "", DEMO " --for 1h", ""},
      {"load", "", DEMO " --for 1h", ""},
      {"scorecard", "", DEMO, ""},
      {"score", "", "", ""},
      {"compare", DEMO " --estimators leveling --for 1s", "", ""},
      {"dds-config", " ", "", ""},
  };
  return all;
}

/// A line on which nobody says anything, as FOLDER/port.
class SilentPort {
 public:
  explicit SilentPort(const Folder& folder) : master_(::posix_openpt(O_RDWR | O_NOCTTY)) {
    ::grantpt(master_);
    ::unlockpt(master_);
    std::filesystem::create_symlink(::ptsname(master_), folder / "port");
  }
  ~SilentPort() { ::close(master_); }
  SilentPort(const SilentPort&) = delete;
  SilentPort& operator=(const SilentPort&) = delete;

 private:
  int master_;
};

std::string in(const Folder& folder, std::string arguments) {
  const std::string path = (folder / "").string();
  for (auto at = arguments.find("@/"); at != std::string::npos; at = arguments.find("@/"))
    arguments.replace(at, 2, path);
  return arguments;
}

std::vector<std::string> commands_of_the_help() {
  const std::string help = drydock("--help").output;
  std::istringstream lines(help.substr(help.find("Subcommands:\n") + 13));
  std::vector<std::string> names;
  for (std::string line; std::getline(lines, line);)
    if (line.size() > 2 && line.starts_with("  ") && line[2] != ' ')
      names.push_back(line.substr(2, line.find(' ', 2) - 2));
  return names;
}

/// The option of a help page, with its text.
bool has_for(const std::string& command) {
  return drydock(command + " --help").output.find("--for ") != std::string::npos;
}

TEST(ExitRule, KnowsEveryCommandOfTheHelp) {
  std::vector<std::string> known;
  for (const auto& row : rows()) known.push_back(row.command);
  EXPECT_THAT(commands_of_the_help(), testing::UnorderedElementsAreArray(known));
}

TEST(ExitRule, AnOptionThatACommandDoesNotHaveIsTwo) {
  for (const auto& row : rows()) {
    const auto refused = drydock(row.command + " --no-such-option");
    EXPECT_EQ(refused.exit_code, 2) << row.command << refused.output;
  }
}

TEST(ExitRule, AHelpThatCannotBeWrittenIsOneAndSaysWhy) {
  for (const auto& row : rows()) {
    const auto full = drydock(row.command + " --help 2>&1 >/dev/full #");
    EXPECT_EQ(full.exit_code, 1) << row.command;
    EXPECT_THAT(full.output,
                HasSubstr("standard output cannot be written: No space left on device"))
        << row.command;
  }
}

TEST(ExitRule, AnOutputThatCannotBeWrittenIsOneAndSaysWhy) {
  for (const auto& row : rows()) {
    if (row.prints.empty()) continue;
    const auto full = drydock(row.command + " " + row.prints + " 2>&1 >/dev/full #");
    EXPECT_EQ(full.exit_code, 1) << row.command;
    EXPECT_THAT(full.output, HasSubstr("No space left on device")) << row.command;
  }
}

TEST(ExitRule, ATimeOfNothingIsTwoForEveryCommandThatTakesATime) {
  std::vector<std::string> tried;
  for (const auto& row : rows()) {
    if (row.command == "fault" || !has_for(row.command)) continue;
    tried.push_back(row.command);
    const auto refused = drydock(row.command + " --for 0s");
    EXPECT_EQ(refused.exit_code, 2) << row.command;
    EXPECT_THAT(refused.output, HasSubstr("'0s' is no time to run")) << row.command;
  }
  EXPECT_THAT(tried, testing::IsSupersetOf({"run", "record", "monitor", "sensor", "soak"}));
}

class ASignalBeforeTheEnd : public testing::TestWithParam<int> {};

TEST_P(ASignalBeforeTheEnd, Is130InEveryCommandThatLasts) {
  for (const auto& row : rows()) {
    if (row.lasts.empty()) continue;
    const Folder folder;
    const SilentPort port(folder);
    ASSERT_EQ(std::system(("mkfifo " + (folder / "pipe").string()).c_str()), 0);
    Running run(folder, row.command + " " + in(folder, row.lasts), "out.txt");
    ASSERT_TRUE(run.catches(GetParam())) << row.command;
    EXPECT_TRUE(run.says(row.says)) << row.command;
    EXPECT_EQ(run.end(GetParam()), 130) << row.command << ": " << run.output();
    if (row.command == "soak" || row.command == "load")
      EXPECT_THAT(run.output(), testing::Not(HasSubstr("PASS"))) << "the whole time was asked for";
  }
}

/// The sentence is from gpsd's page on NMEA 0183; its sum is that of its characters.
TEST_P(ASignalBeforeTheEnd, EndsADecodeOfALivePipeWithTheCounts) {
  const Folder folder;
  const auto pipe = (folder / "pipe").string();
  ASSERT_EQ(std::system(("mkfifo " + pipe).c_str()), 0);
  Running decode(folder, "decode --protocol nmea0183 " + pipe, "out.txt");
  std::ofstream line(pipe);
  line << "$GPGLL,4916.45,N,12311.12,W,225444,A*31\r\n" << std::flush;
  ASSERT_TRUE(decode.says("\"latitude_deg\":49.27416"));
  EXPECT_EQ(decode.end(GetParam()), 130);
  EXPECT_THAT(decode.output(), HasSubstr("1 frames, 1 messages, 0 bad checksums, 0 bytes skipped"));
}

INSTANTIATE_TEST_SUITE_P(Of, ASignalBeforeTheEnd, testing::Values(SIGINT, SIGTERM, SIGHUP));

TEST(ExitRule, ASecondCtrlCEndsAtOnce) {
  const Folder folder;
  ASSERT_EQ(std::system(("mkfifo " + (folder / "never-read").string()).c_str()), 0);
  Running run(folder,
              "run " DEMO " --for 100h --speed max --json " + (folder / "never-read").string(),
              "out.txt");
  ASSERT_TRUE(run.says("streaming"));
  run.tell(SIGINT);
  ASSERT_TRUE(run.says("expectations met"));  // now it waits for somebody who reads the file
  EXPECT_EQ(run.end(SIGINT), 130);
}

}  // namespace exit_rule_test
