// The completions that shells offer for an incomplete command line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/hil/program/program.hpp"

namespace completion_test {

using program::drydock;
using program::Folder;
using testing::HasSubstr;

TEST(Program, BashCompletesCommandsOptionsAndValues) {
  const Folder folder;
  std::ofstream(folder / "try.sh")
      << "source <(drydock completion bash)\n"
         "complete_at() { COMP_WORDS=(\"$@\"); COMP_CWORD=$(($# - 1)); "
         "_drydock; echo \"${COMPREPLY[*]}\"; }\n"
         "complete_at drydock mon\n"
         "complete_at drydock run --spe\n"
         "complete_at drydock run --speed m\n"
         "complete_at drydock decode --protocol pd\n";
  const auto outcome = drydock("--version; PATH=$(dirname " DRYDOCK_PROGRAM "):$PATH bash " +
                               (folder / "try.sh").string());
  EXPECT_THAT(outcome.output, HasSubstr("\nmonitor\n--speed\nmax\npd0 pd4 pd5 pd6\n"));
}

/// What bash offers for the last of the words.
std::string bash_offers(const std::string& words) {
  const Folder folder;
  std::ofstream(folder / "try.sh") << "source <(drydock completion bash)\n"
                                      "COMP_WORDS=("
                                   << words
                                   << ")\n"
                                      "COMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n"
                                      "_drydock; echo \"${COMPREPLY[*]}\"\n";
  return drydock("--version >/dev/null; PATH=$(dirname " DRYDOCK_PROGRAM "):$PATH bash " +
                 (folder / "try.sh").string())
      .output;
}

TEST(BashCompletion, KnowsTheValuesOfOptionsAndOfPlaces) {
  EXPECT_EQ(bash_offers("drydock study ''"), "leveling mixing roll velocity calibration\n");
  EXPECT_EQ(bash_offers("drydock export d.mcap --to ''"), "candump pcapng raw csv nmea\n");
  EXPECT_THAT(bash_offers("drydock replay d.pd0 --protocol pd"), HasSubstr("pd0 pd4 pd5 pd6"));
  EXPECT_EQ(bash_offers("drydock replay d.pd0 --kind g"), "gnss\n");
  EXPECT_EQ(bash_offers("drydock completion ''"), "bash zsh\n");
  EXPECT_EQ(bash_offers("drydock bridge ''"), "mavlink\n");
  EXPECT_EQ(bash_offers("drydock bridge mavlink r.toml --messages ''"),
            "position-delta odometry both\n");
  EXPECT_EQ(bash_offers("drydock help scorec"), "scorecard\n");
}

TEST(BashCompletion, OffersManoeuvresBehindTheVehicleAndShippedFilesBefore) {
  EXPECT_THAT(bash_offers("drydock maneuver nps"), HasSubstr("nps-auv-ii nps-auv-ii-asymmetric"));
  EXPECT_EQ(bash_offers("drydock maneuver nps-auv-ii ''"), "turning-circle zigzag spiral dive\n");
  EXPECT_EQ(bash_offers("drydock maneuver --speed 2 nps-auv-ii zi"), "zigzag\n");
  EXPECT_THAT(bash_offers("drydock run dem"), HasSubstr("demo"));
  EXPECT_EQ(bash_offers("drydock campaign turn"), "turning\n");
  EXPECT_THAT(bash_offers("drydock check bluero"), HasSubstr("bluerov2"));
}

TEST(BashCompletion, KnowsTheDevicesAndFaultsOfTheRigAtHand) {
  const std::string fault = "drydock fault rig_config/rigs/demo.toml ";
  EXPECT_EQ(bash_offers(fault + "''"), "set clear list words\n");
  EXPECT_EQ(bash_offers(fault + "set ''"), "dvl emlog gnss imu depth actuators\n");
  EXPECT_EQ(bash_offers(fault + "set dvl bottom"), "bottom-lost\n");
  EXPECT_EQ(bash_offers(fault + "set emlog bottom"), "\n");  // only a DVL hears the sea bed
  EXPECT_EQ(bash_offers("drydock scorecard rig_config/rigs/demo.toml --devices im"), "imu\n");
}

TEST(BashCompletion, KnowsUnitsExamplesAndDescriptions) {
  EXPECT_EQ(bash_offers("drydock monitor demo --units k"), "kn km/h kPa\n");
  EXPECT_EQ(bash_offers("drydock monitor demo --units kn,ba"), "kn,bar\n");
  EXPECT_EQ(bash_offers("drydock example bluero"), "bluerov2\n");
  EXPECT_EQ(bash_offers("drydock decode --protocol valep"), "valeport-vat.toml\n");
}

TEST(BashCompletion, KnowsTheFaultsOfAllDevicesOfTheRigAtHand) {
  const std::string scorecard = "drydock scorecard rig_config/rigs/demo.toml ";
  EXPECT_EQ(bash_offers(scorecard + "--faults bottom"), "bottom-lost\n");
  EXPECT_EQ(bash_offers(scorecard + "--faults flip,unp"), "flip,unplug\n");
  EXPECT_EQ(bash_offers(scorecard + "--devices dvl,im"), "dvl,imu\n");
}

TEST(BashCompletion, KnowsDevicesOfRigsAndRecordingsEstimatorsAndCases) {
  const std::string dive = "fixtures/dives/dvl-finds-the-bottom/dive.mcap";
  EXPECT_EQ(bash_offers("drydock topic demo ''"), "dvl emlog gnss imu depth actuators\n");
  EXPECT_EQ(bash_offers("drydock topic " + dive + " ''"), "dvl\n");
  EXPECT_EQ(bash_offers("drydock replay " + dive + " --only ''"), "dvl\n");
  EXPECT_EQ(bash_offers("drydock scorecard demo --also emlog:bi"), "emlog:bias\n");
  EXPECT_EQ(bash_offers("drydock scorecard demo --also emlog : bi"), "bias\n");  // as bash divides
  EXPECT_EQ(bash_offers("drydock compare demo --estimators lev"), "leveling\n");
  EXPECT_EQ(bash_offers("drydock compare demo --estimators mixing,lev"), "mixing,leveling\n");
  EXPECT_EQ(bash_offers("drydock study velocity --cases case2"), "case2 case2_20\n");
}

/// Runs an interactive zsh on each line, in a folder with two files, and returns its completions
/// for the last word.
class Zsh : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("command -v zsh >/dev/null") != 0) {
      ASSERT_EQ(std::getenv("CI"), nullptr) << "zsh is missing";
      GTEST_SKIP() << "zsh is not installed (package zsh)";
    }
    std::ofstream(folder_ / "_drydock") << drydock("completion zsh").output;
    std::filesystem::create_directory(folder_ / "pier");
    for (const char* name : {"pier/pier.toml", "pier/dive.mcap"}) std::ofstream(folder_ / name);
  }
  std::string offers(const std::string& line) const {
    const auto offered =
        drydock("--version >/dev/null; cd " + (folder_ / "pier").string() +
                "; PATH=$(dirname " DRYDOCK_PROGRAM "):$PATH zsh -f " DRYDOCK_SOURCE_DIR
                "/tests/hil/program/zsh_offers.zsh " +
                (folder_ / "").string() + " '" + line + "'");
    EXPECT_EQ(offered.exit_code, 0) << offered.output;
    return offered.output;
  }

  Folder folder_;
};

TEST_F(Zsh, OffersTheCommands) {
  const auto all = offers("drydock ");
  for (const char* command : {"probe", "monitor", "record", "replay", "export", "completion"})
    EXPECT_THAT(all, HasSubstr(std::string{command} + "\n"));
  EXPECT_EQ(offers("drydock rec"), "record\nrecover\n");
}

TEST_F(Zsh, OffersTheOptionsOfACommandAndTheirValues) {
  EXPECT_EQ(
      offers("drydock record -"),
      "--cores\n--for\n--help\n--keep\n--output\n--overwrite\n--priority\n--realtime\n--serve\n"
      "--split-every\n--split-size\n"
      "--token\n-h\n-o\n");
  EXPECT_EQ(offers("drydock record -o a.mcap --o"), "--overwrite\n");  // "-o" is given, so zsh does
                                                                       // not offer "--output"
  EXPECT_EQ(offers("drydock run --speed "), "1\nmax\n");
  EXPECT_EQ(offers("drydock decode --protocol pd"), "pd0\npd4\npd5\npd6\n");
  EXPECT_EQ(offers("drydock record --for "), "");
}

TEST_F(Zsh, OffersFilesForARigAndForWhatAnOptionWrites) {
  EXPECT_THAT(offers("drydock record "), HasSubstr("demo\ndescribed\ndive.mcap\n"));
  EXPECT_EQ(offers("drydock record p"), "pier.toml\n");
  EXPECT_EQ(offers("drydock record pier.toml -o "), "dive.mcap\npier.toml\n");
  const auto behind = offers("drydock record pier.toml ");  // the command takes one rig file, and
                                                            // it is there already
  EXPECT_THAT(behind, HasSubstr("--output\n"));
  EXPECT_THAT(behind, testing::Not(HasSubstr("dive.mcap")));
  EXPECT_EQ(offers("drydock check pier.toml di"), "digiquartz\ndive.mcap\n");
  EXPECT_EQ(offers("drydock replay d"), "dive.mcap\n");
}

TEST_F(Zsh, OffersManoeuvresAndStudies) {
  EXPECT_EQ(offers("drydock maneuver a.toml "), "dive\nspiral\nturning-circle\nzigzag\n");
  EXPECT_EQ(offers("drydock study "), "calibration\nleveling\nmixing\nroll\nvelocity\n");
}

TEST_F(Zsh, OffersUnitsExamplesDescriptionsAndFaults) {
  EXPECT_EQ(offers("drydock monitor pier.toml --units k"), "kPa\nkm/h\nkn\n");
  EXPECT_EQ(offers("drydock example bluero"), "bluerov2\n");
  EXPECT_EQ(offers("drydock decode --protocol valep"), "valeport-vat.toml\n");
  EXPECT_EQ(offers("drydock scorecard demo --faults bottom"), "bottom-lost\n");
  EXPECT_EQ(offers("drydock scorecard demo --also emlog:bi"), "emlog:bias\n");
  EXPECT_EQ(offers("drydock topic demo g"), "gnss\n");
  EXPECT_EQ(offers("drydock study velocity --cases case2"), "case2\ncase2_20\n");
}

TEST_F(Zsh, TakesTheCompletionFromSourceToo) {
  const auto outcome = drydock(
      "--version >/dev/null; PATH=$(dirname " DRYDOCK_PROGRAM
      "):$PATH zsh -f -c 'autoload -Uz compinit; compinit -D -u; source <(drydock completion zsh); "
      "print $_comps[drydock]'");
  EXPECT_EQ(outcome.output, "_drydock\n");
}

}  // namespace completion_test
