// Files that come with the program, by name, and starts of new ones.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "tests/hil/program/program.hpp"

namespace shipped_files_test {

using program::drydock;
using program::Folder;
using program::Outcome;
using testing::HasSubstr;

/// In an empty folder, where no path of the source tree leads anywhere.
Outcome elsewhere(const Folder& folder, const std::string& arguments) {
  return drydock("--version >/dev/null; cd " + (folder / "").string() + " && " DRYDOCK_PROGRAM " " +
                 arguments);
}

TEST(ShippedFiles, ARigIsFoundByItsNameItsFileAndItsPathFromAnyFolder) {
  const Folder folder;
  for (const std::string rig : {"demo", "demo.toml", "rig_config/rigs/demo.toml"}) {
    const auto run = elsewhere(folder, "run " + rig + " --for 1s --speed max");
    EXPECT_THAT(run.output, HasSubstr("demo: 1.0 s of bench time")) << rig;
  }
}

TEST(ShippedFiles, AFileOfTheSameNameHereComesFirst) {
  const Folder folder;
  std::ofstream(folder / "demo.toml") << "[rig]\nname = \"mine\"\nno_such_key = 1\n";
  EXPECT_THAT(elsewhere(folder, "run demo.toml --for 1s").output,
              HasSubstr("demo.toml:3:1: /rig/no_such_key: unknown key"));
}

/// Such as that of a campaign's results.
TEST(ShippedFiles, AFolderOfTheNameHidesNoFile) {
  const Folder folder;
  std::filesystem::create_directory(folder / "demo");
  EXPECT_EQ(elsewhere(folder, "check demo").exit_code, 0);
  EXPECT_EQ(elsewhere(folder, "run demo --for 1s --speed max --report demo").exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(folder / "demo/index.html"));
}

TEST(ShippedFiles, AVehicleAndAGradeAreFoundByName) {
  const Folder folder;
  EXPECT_EQ(elsewhere(folder, "maneuver nps-auv-ii turning-circle").exit_code, 0);
  EXPECT_EQ(elsewhere(folder, "sensor xsens-mti-630 --for 20s").exit_code, 0);
}

TEST(ShippedFiles, ARigThatIsNowhereIsAnErrorOfItsOwnName) {
  const Folder folder;
  const auto run = elsewhere(folder, "run demmo --for 1s");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.output, HasSubstr("demmo: cannot be read: No such file"));
  EXPECT_THAT(run.output, HasSubstr("(did you mean 'demo'?)"));
  EXPECT_THAT(elsewhere(folder, "run nothing-like-it --for 1s").output,
              HasSubstr("`drydock example` lists the files that come with the program"));
}

TEST(ShippedFiles, TheListHasOneOfEachKindWithWhatItsFileSaysFirst) {
  const Folder folder;
  const auto list = elsewhere(folder, "example");
  EXPECT_EQ(list.exit_code, 0);
  EXPECT_THAT(list.output, testing::ContainsRegex(
                               "  demo +The demonstration: six emulated sensors of an underwater"));
  for (const char* name : {"  s-path", "  xsens-mti-630", "  nps-auv-ii "})
    EXPECT_THAT(list.output, HasSubstr(name));
  EXPECT_THAT(elsewhere(folder, "example s-path").output, HasSubstr("amplitude_deg = 45.0"));
  EXPECT_EQ(elsewhere(folder, "example nothing").exit_code, 2);
  EXPECT_THAT(elsewhere(folder, "example turning").output, HasSubstr("[campaign]"));
  EXPECT_THAT(elsewhere(folder, "example nmea-depth").output, HasSubstr("[sensor]"));
  EXPECT_THAT(list.output, HasSubstr("  nmea-depth               Echo sounder with NMEA 0183"));
  std::istringstream lines(list.output);
  for (std::string line; std::getline(lines, line);)  // no sentence ends within its brackets
    EXPECT_EQ(
        std::ranges::count(line, '(') > std::ranges::count(line, ')') && !line.ends_with("..."),
        false)
        << line;
}

TEST(ShippedFiles, OfTwoKindsWithOneNameEachIsPrintedByKindAndName) {
  const Folder folder;
  const auto rig = elsewhere(folder, "example loop"),
             mission = elsewhere(folder, "example missions/loop");
  EXPECT_THAT(rig.output, HasSubstr("[[device]]"));
  EXPECT_THAT(rig.output,
              HasSubstr("\n# drydock example missions/loop prints the other of that name"));
  EXPECT_EQ(mission.exit_code, 0);
  EXPECT_THAT(mission.output, HasSubstr("[mission]"));
  EXPECT_THAT(mission.output, testing::Not(HasSubstr("[[device]]")));
}

TEST(ShippedFiles, CampaignsAndDescriptionsAreCheckedAsWhatTheyAre) {
  const Folder folder;
  EXPECT_THAT(elsewhere(folder, "check turning").output, HasSubstr("turning.toml: ok"));
  EXPECT_THAT(elsewhere(folder, "check nmea-depth").output, HasSubstr("nmea-depth.toml: ok"));
  std::ofstream(folder / "c.toml") << "[campaign]\nname = \"c\"\nrepetition = 2\n";
  const auto refused = elsewhere(folder, "check c.toml");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.output, HasSubstr("c.toml:3:1: /campaign/repetition: unknown key (did you "
                                        "mean 'repetitions'?)"));
}

TEST(ShippedFiles, ACopyOfARigIsAcceptedByCheckWhereverItIs) {
  const Folder folder;
  for (const std::string rig : {"demo", "loop", "velocity-paper"}) {
    elsewhere(folder, "example " + rig + " > my-rig.toml");
    EXPECT_EQ(elsewhere(folder, "check my-rig.toml").output, "my-rig.toml: ok\n") << rig;
  }
}

TEST(NewFile, OfEachKindIsAcceptedByCheck) {
  const Folder folder;
  for (const std::string kind : {"rig", "mission", "waypoints", "sensor", "vehicle"}) {
    const auto made = elsewhere(folder, "new " + kind + " my-" + kind);
    EXPECT_EQ(made.exit_code, 0) << made.output;
    EXPECT_EQ(elsewhere(folder, "check my-" + kind + ".toml").output, "my-" + kind + ".toml: ok\n");
  }
}

TEST(NewFile, OfARigRunsAndMeetsItsExpectation) {
  const Folder folder;
  elsewhere(folder, "new rig my-bench");
  const auto run = elsewhere(folder, "run my-bench --for 10s --speed max");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("my-bench: 10.0 s of bench time"));
  EXPECT_THAT(run.output, HasSubstr("PASS dvl state: streaming"));
}

TEST(NewFile, ReplacesNoFileUnasked) {
  const Folder folder;
  std::ofstream(folder / "a.toml") << "precious";
  const auto refused = elsewhere(folder, "new rig a");
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.output, HasSubstr("--overwrite replaces it"));
  EXPECT_EQ(program::read_file(folder / "a.toml"), "precious");
  EXPECT_EQ(elsewhere(folder, "new rig a --overwrite").exit_code, 0);
  EXPECT_EQ(elsewhere(folder, "new rig ../a").exit_code, 2);
}

TEST(Maneuver, WithoutANameListsThem) {
  const auto asked = drydock("maneuver nps-auv-ii");
  EXPECT_EQ(asked.exit_code, 2);
  EXPECT_THAT(asked.output, HasSubstr("turning-circle, zigzag, spiral or dive; or --schedule"));
}

}  // namespace shipped_files_test
