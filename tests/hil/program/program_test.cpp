// The program for a person or a script: help, wrong usage, errors in a rig file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/hil/program/program.hpp"

namespace program_test {

using program::drydock;
using program::Folder;
using testing::HasSubstr;

/// The first words of the lines under `Subcommands:`.
std::vector<std::string> commands_of(const std::string& help) {
  std::istringstream lines(help.substr(help.find("Subcommands:\n") + 13));
  std::vector<std::string> names;
  for (std::string line; std::getline(lines, line);) {
    if (line.size() < 3 || !line.starts_with("  ") || line[2] == ' ') continue;
    names.push_back(line.substr(2, line.find(' ', 2) - 2));
  }
  return names;
}

TEST(Program, HelpOfEveryCommandShowsAnExample) {
  const auto commands = commands_of(drydock("--help").output);
  EXPECT_THAT(commands, testing::IsSupersetOf({"run", "probe", "scorecard"}));
  for (const std::string& command : commands) {
    const auto help = drydock(command + " --help");
    EXPECT_EQ(help.exit_code, 0) << command;
    EXPECT_THAT(help.output, HasSubstr("Example")) << command;
  }
}

TEST(Program, WrongUsageAndWrongConfigurationExitWithTwo) {
  EXPECT_EQ(drydock("").exit_code, 2);
  EXPECT_EQ(drydock("sail").exit_code, 2);
  const auto duration = drydock("run rig_config/rigs/demo.toml --for 5parsec");
  EXPECT_EQ(duration.exit_code, 2);
  EXPECT_THAT(duration.output, HasSubstr("allowed: 90, 60s, 10min, 5.5h"));
  const auto served = drydock("run rig_config/rigs/demo.toml --speed max --serve");
  EXPECT_EQ(served.exit_code, 2);
  EXPECT_THAT(served.output, HasSubstr("not with --speed max"));
  const auto missing = drydock("run nowhere.toml");
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_THAT(missing.output, HasSubstr("nowhere.toml"));
}

TEST(Program, ABadLinkIsNamedWithFileLineAndColumn) {
  const Folder folder;
  std::ofstream(folder / "rig.toml")
      << "[rig]\nname = \"x\"\n[[device]]\nname = \"dvl\"\nkind = \"dvl\"\nprotocol = \"pd0\"\n"
         "link = \"seriel:/dev/ttyUSB0\"\nrate_hz = 5\n";
  const auto check = drydock("check " + (folder / "rig.toml").string());
  EXPECT_EQ(check.exit_code, 2);
  EXPECT_THAT(check.output, HasSubstr("rig.toml:7:"));
  EXPECT_THAT(check.output, HasSubstr("serial"));
}

TEST(Program, TheShippedRigFilesAreGood) {
  const auto check = drydock("check rig_config/rigs/demo.toml rig_config/missions/*.toml");
  EXPECT_EQ(check.exit_code, 0) << check.output;
}

TEST(Program, TheDoctorNarrowsToARigAndNamesACommandForWhatIsWrong) {
  const auto machine = drydock("doctor --json");
  EXPECT_TRUE(nlohmann::json::parse(machine.output)["checks"].size() > 4) << machine.output;
  const Folder folder;
  std::ofstream(folder / "rig.toml")
      << "[rig]\nname = \"x\"\n[[device]]\nname = \"dvl\"\nkind = \"dvl\"\nprotocol = \"pd0\"\n"
         "link = \"serial:/dev/nowhere?baud=9600\"\n";
  const auto rig = drydock("doctor " + (folder / "rig.toml").string());
  EXPECT_EQ(rig.exit_code, 1);
  EXPECT_THAT(rig.output, HasSubstr("/dev/nowhere is not there"));
  EXPECT_THAT(rig.output, HasSubstr("drydock probe --all"));
}

TEST(Program, EveryCommandThatWritesAFileHasTheSameWordForReplacingOne) {
  for (const char* command : {"run", "record", "replay", "export", "recover", "cut", "bisect"}) {
    const auto help = drydock(std::string{command} + " --help");
    EXPECT_THAT(help.output, HasSubstr("--overwrite")) << command;
  }
  for (const char* everything : {"man", "completion bash", "completion zsh"}) {
    const auto text = drydock(everything).output;
    EXPECT_THAT(text, HasSubstr("overwrite")) << everything;
    EXPECT_THAT(text, testing::Not(HasSubstr("-force"))) << everything;
  }
}

TEST(Program, TheManualPageIsSoundRoff) {
  const auto page = drydock("man | groff -man -ww -z");
  EXPECT_EQ(page.exit_code, 0);
  EXPECT_EQ(page.output, "");
  EXPECT_THAT(drydock("man").output, HasSubstr(".SS probe"));
}

}  // namespace program_test
