// What is wrong with a file is said, a command that fails leaves none behind, and a word that is
// misspelled gets a suggestion.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <utility>
#include <vector>

#include "tests/hil/program/program.hpp"

namespace file_trouble_test {

using program::drydock;
using program::Folder;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

const std::string dive = "fixtures/dives/dvl-finds-the-bottom/dive.mcap";

/// The program of a user who may read this tree, and not what only root may.
program::Outcome as_nobody(const std::string& arguments) {
  const std::string drop = ::getuid() == 0 ? "setpriv --reuid=65534 --clear-groups" : "";
  return drydock(arguments, drop);
}

struct Files {
  Folder folder;
  std::string empty = (folder / "empty.mcap").string(),
              garbage = (folder / "garbage.mcap").string(),
              secret = (folder / "secret.mcap").string();
  Files() {
    std::ofstream{empty};
    std::ofstream(garbage) << "this is no recording\n";
    std::ofstream(secret) << "nobody may read this\n";
    fs::permissions(secret, fs::perms::none);
    fs::permissions(folder / "", fs::perms::all);
  }
};

TEST(FileTrouble, EachIsCalledWhatItIsByTheCommandsOfRecordings) {
  const Files files;
  for (const std::string command : {"replay", "cut", "recover", "export --to csv", "diagnose"}) {
    EXPECT_THAT(drydock(command + " " + files.empty).output, HasSubstr("is empty")) << command;
    EXPECT_THAT(drydock(command + " /tmp/nowhere.mcap").output,
                HasSubstr("No such file or directory"))
        << command;
    const auto secret = as_nobody(command + " " + files.secret);
    EXPECT_EQ(secret.exit_code, 1) << command;
    EXPECT_THAT(secret.output, HasSubstr("Permission denied")) << command;
  }
  for (const std::string command : {"replay", "cut", "recover", "export --to csv"}) {
    const auto garbage = drydock(command + " " + files.garbage);
    EXPECT_EQ(garbage.exit_code, 1) << command;
    EXPECT_THAT(garbage.output, HasSubstr("not an MCAP file")) << command;
  }
}

TEST(FileTrouble, ARecordingThatCannotBeReadIsOneInEveryCommandThatTakesOne) {
  const Files files;
  const std::string out = " -o " + (files.folder / "out").string(),
                    dives = (files.folder / "dives.mcap").string();
  fs::create_directory(dives);
  for (const std::string command :
       {"replay @", "info @", "cut @", "recover @", "bisect @ --run 'test {}'", "diagnose @",
        "export @ --to csv", "diff @ @", "track @", "calibrate @",
        "compare @ --estimators leveling", "characterize @ --device imu", "topic @ imu",
        "score @ --truth @"}) {
    for (const auto& [file, word] :
         {std::pair{files.empty, "is empty"}, std::pair{dives, "is a folder"}}) {
      auto typed = command;
      for (auto at = typed.find('@'); at != std::string::npos; at = typed.find('@'))
        typed.replace(at, 1, file);
      const auto refused = drydock(typed);
      EXPECT_EQ(refused.exit_code, 1) << typed << refused.output;
      EXPECT_THAT(refused.output, HasSubstr(word)) << typed;
    }
  }
  for (const std::string& command : std::vector<std::string>{
           "track", "calibrate", "diagnose", "compare --estimators leveling", "twin" + out}) {
    const auto garbage = drydock(command + " " + files.garbage);
    EXPECT_EQ(garbage.exit_code, 1) << command;
    EXPECT_THAT(garbage.output, HasSubstr("not an MCAP file")) << command;
  }
}

TEST(FileTrouble, AWriteThatFailedSaysWhy) {
  for (const std::string command :
       {"maneuver nps-auv-ii zigzag --csv", "study mixing --runs 1 --json",
        "scorecard rig_config/rigs/demo.toml --devices dvl --faults flip --json",
        "sky --ephemeris fixtures/rinex/walker.rnx --at 2026-11-21T09:00:00Z --from 36,129 "
        "--plot"}) {
    const auto full = drydock(command + " /dev/full");
    EXPECT_EQ(full.exit_code, 1) << command;
    EXPECT_THAT(full.output, HasSubstr("/dev/full")) << command;
    EXPECT_THAT(full.output, HasSubstr("No space left on device")) << command;
  }
}

TEST(FileTrouble, WhatStandsThereIsNotReplacedUnasked) {
  const Files files;
  for (const std::string& command : std::vector<std::string>{
           "cut " + dive + " -o ", "export " + dive + " --to pcapng -o ",
           "calibrate " + dive + " --write ", "track " + dive + " --as csv -o "}) {
    const auto refused = drydock(command + files.garbage);
    EXPECT_EQ(refused.exit_code, 1) << command;
    EXPECT_THAT(refused.output, HasSubstr("--overwrite replaces it")) << command;
  }
}

TEST(FileTrouble, AFolderIsNotToBeReplacedByAFile) {
  const Folder folder;
  for (const std::string& command : std::vector<std::string>{
           "cut " + dive + " -o ", "recover " + dive + " -o ",
           "export " + dive + " --to pcapng -o ", "calibrate " + dive + " --write ",
           "track " + dive + " --as csv -o ", "run demo --for 1s --speed max --record "}) {
    const auto refused = drydock(command + (folder / "").string());
    EXPECT_EQ(refused.exit_code, 1) << command;
    EXPECT_THAT(refused.output, HasSubstr("is a folder, not a file")) << command;
    EXPECT_THAT(refused.output, Not(HasSubstr("--overwrite"))) << command;
  }
}

/// Without the right to make it, the folder is what cannot be written, not what is missing in it.
TEST(FileTrouble, AFolderThatCannotBeMadeSaysWhy) {
  const Folder folder;
  fs::permissions(folder / "", fs::perms(0555));
  const auto refused = as_nobody("export " + dive + " --to raw -o " + (folder / "raw").string());
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.output, HasSubstr("raw: Permission denied"));
}

TEST(WrongUsage, OfANameThatTheRecordingDoesNotHaveIsTwo) {
  for (const std::string command : {"cut", "export --to csv", "replay"}) {
    const auto refused = drydock(command + " " + dive + " --only sonar");
    EXPECT_EQ(refused.exit_code, 2) << command;
    EXPECT_THAT(refused.output, HasSubstr("there is no \"sonar\" in the recording")) << command;
  }
  EXPECT_EQ(drydock("bisect " + dive + " --run true").exit_code, 2);
}

TEST(FileTrouble, EachIsCalledWhatItIsByTheRigFile) {
  const Files files;
  EXPECT_THAT(drydock("check " + files.empty).output, HasSubstr("cannot be read: is empty"));
  EXPECT_THAT(drydock("check /tmp").output, HasSubstr("cannot be read: is a folder"));
  EXPECT_THAT(drydock("check /dev/null").output, HasSubstr("is a device or a pipe"));
  const auto secret = as_nobody("check " + files.secret);
  EXPECT_EQ(secret.exit_code, 2);
  EXPECT_THAT(secret.output, HasSubstr("cannot be read: Permission denied"));
}

TEST(FileTrouble, ACommandThatFailsLeavesNoFileBehind) {
  const Files files;
  const Folder out;
  const std::string to = (out / "out").string();
  for (const std::string& command : std::vector<std::string>{
           "cut " + dive + " --from 1000s -o ", "cut " + files.garbage + " -o ",
           "recover " + files.garbage + " -o ", "export " + files.garbage + " --to csv -o ",
           "export " + dive + " --to candump -o ",
           "run rig_config/rigs/demo.toml --for 1s --serve "
           "127.0.0.1:99999 --record ",
           "drive rig_config/rigs/demo.toml --for 1s --serve 127.0.0.1:99999 --record "}) {
    const auto failed = drydock(command + to);
    EXPECT_NE(failed.exit_code, 0) << command;
    EXPECT_FALSE(fs::exists(to)) << command << failed.output;
  }
}

TEST(FileTrouble, ARangeThatEndsBeforeItBeginsIsCalledReversed) {
  for (const std::string command : {"cut", "replay", "export --to csv"}) {
    const auto refused = drydock(command + " " + dive + " --from 5s --to 2s");
    EXPECT_EQ(refused.exit_code, 2) << command;
    EXPECT_THAT(refused.output, HasSubstr("reversed or empty: it begins at 5 s, ends at 2 s"));
  }
}

TEST(Misspelled, ACommandGetsASuggestion) {
  const auto runn = drydock("runn rig_config/rigs/demo.toml");
  EXPECT_EQ(runn.exit_code, 2);
  EXPECT_THAT(runn.output, HasSubstr("'runn' is no command (did you mean 'run'?)"));
  EXPECT_THAT(drydock("rnu").output, HasSubstr("'rnu' is no command (did you mean 'run'?)"));
  EXPECT_THAT(drydock("run demo --sped max").output, HasSubstr("did you mean '--speed'?"));
  EXPECT_THAT(drydock("help scorcard").output, HasSubstr("did you mean 'scorecard'?"));
  EXPECT_THAT(drydock("zzzzzzzz").output, HasSubstr("'zzzzzzzz' is no command; drydock --help"));
}

TEST(Misspelled, AnOptionGetsASuggestion) {
  const auto run = drydock("run rig_config/rigs/demo.toml --reprot out");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.output, HasSubstr("(did you mean '--report'?)"));
}

TEST(Misspelled, AKeyThatOnlyBeginsRightGetsTheWholeOne) {
  const Folder folder;
  std::ofstream(folder / "rig.toml")
      << "[rig]\nname = \"x\"\n[[device]]\nname = \"dvl\"\nkind = \"dvl\"\nprotocol = \"pd0\"\n"
         "link = \"pty:dvl\"\nrate = 5\n";
  EXPECT_THAT(drydock("check " + (folder / "rig.toml").string()).output,
              HasSubstr("/device/0/rate: unknown key (did you mean 'rate_hz'?)"));
}

TEST(Help, OfACommandIsThatOfItsOption) {
  for (const std::string command : {"run", "info", "scorecard"})
    EXPECT_EQ(drydock("help " + command).output, drydock(command + " --help").output);
  EXPECT_EQ(drydock("help").output, drydock("--help").output);
  EXPECT_THAT(drydock("help fault set").output, HasSubstr("drydock fault set [OPTIONS] DEVICE"));
}

}  // namespace file_trouble_test
