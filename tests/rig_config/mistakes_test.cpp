// What a person gets wrong in a file is told with what to do about it.
#include <filesystem>
#include <fstream>

#include "rig_config/load.hpp"
#include "rig_config/nearest_file.hpp"
#include "rig_config/shipped.hpp"
#include "tests/rig_config/problems.hpp"

namespace drydock::rig_config::test {
namespace mistakes_test {

using testing::AllOf;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

/// A mistake in lines behind a sound rig of seven lines.
struct Mistake {
  std::string lines;
  std::string place;   ///< "r.toml:LINE:COLUMN: "
  std::string advice;  ///< how the message ends
};

TEST(Mistakes, InTheGrammarAreToldWithWhatToWriteInstead) {
  const std::vector<Mistake> mistakes{
      {"rate_hz = 5,0\n", "r.toml:8:12: ", "; a number has a point, not a comma"},
      {"emulate = { velocity_bias_mps = 0,002 }\n",
       "r.toml:8:", "; a number has a point, not a comma"},
      {"sound_speed = measured\n", "r.toml:8:", "; a text stands in \"quotes\""},
      {"sound_speed = \"measured\n", "r.toml:8:", "; a closing quote is missing"},
      {"rate_hz = 5\nrate_hz = 6\n", "r.toml:9:", "; keep one of the two"},
      {"rate_hz: 5\n", "r.toml:8:", "; a value is written key = value"},
      {"sound_speed = \"m\xe9\"\n", "r.toml:8:", "; save the file as UTF-8"},
  };
  for (const auto& mistake : mistakes)
    EXPECT_THAT(problems_of(mistake.lines),
                ElementsAre(AllOf(StartsWith(mistake.place), EndsWith(mistake.advice))))
        << mistake.lines;
}

TEST(Mistakes, AnotherFormatThanTomlIsNamed) {
  EXPECT_THAT(problems_of_text("{\"rig\": {\"name\": \"x\"}}"),
              ElementsAre(EndsWith("; this looks like JSON, expected is TOML: key = value")));
}

TEST(Mistakes, OnePairOfBracketsInThePlaceOfTwoIsNamed) {
  EXPECT_THAT(problems_of_text("[rig]\nname = \"x\"\n[device]\nname = \"dvl\"\n"),
              ElementsAre("r.toml:3:1: /device: expected an array, found a table; write "
                          "[[device]] in the place of [device]"));
  EXPECT_THAT(problems_of_text("[rig]\nname = \"x\"\n[estimator]\nname = \"l\"\n[[estimator]]\n"),
              ElementsAre(EndsWith("; a list of tables has two brackets, such as [[device]]")));
}

TEST(Mistakes, CapitalsAreNoOtherWord) {
  EXPECT_THAT(problems_of_text("[rig]\nname = \"x\"\n[[device]]\nname = \"dvl\"\nkind = \"DVL\"\n"
                               "protocol = \"pd0\"\nlink = \"pty:dvl\"\n"),
              testing::Contains(HasSubstr("\"DVL\" is not allowed (did you mean 'dvl'?)")));
  EXPECT_THAT(problems_of("Rate_Hz = 5\n"), ElementsAre(HasSubstr("(did you mean 'rate_hz'?)")));
}

TEST(Mistakes, TheBeginningOfOneKeyIsTakenForIt) {
  for (const auto& [typed, meant] : {std::pair{"rat", "rate_hz"},
                                     {"Rate", "rate_hz"},
                                     {"lat", "latency_ms"},
                                     {"late", "latency_ms"},
                                     {"lever", "lever_arm_m"},
                                     {"mountin", "mounting_deg"}})
    EXPECT_THAT(problems_of(std::string(typed) + " = 5\n"),
                ElementsAre(HasSubstr(std::string("(did you mean '") + meant + "'?)")));
  EXPECT_THAT(problems_of("l = 5\n"), ElementsAre(testing::Not(HasSubstr("did you mean"))));
}

TEST(Mistakes, AFileWithoutItsFirstTableIsTakenForNoOtherKind) {
  namespace fs = std::filesystem;
  const fs::path file = fs::path(testing::TempDir()) / "drydock-no-first-table.toml";
  std::ofstream(file) << "name = \"x\"\n" << dvl_table;
  EXPECT_THAT(lines_of(check_file(file.string())),
              ElementsAre(EndsWith(":1:1: /: a file with blocks [[device]] has a table [rig] too, "
                                   "and here is none")));
  fs::remove(file);
}

TEST(Mistakes, AMisspelledFirstTableIsShownWhereItStands) {
  namespace fs = std::filesystem;
  const fs::path file = fs::path(testing::TempDir()) / "drydock-misspelled-table.toml";
  std::ofstream(file) << "# a rig\n[rigg]\nname = \"x\"\n" << dvl_table;
  EXPECT_THAT(lines_of(check_file(file.string())),
              ElementsAre(EndsWith(":2:2: /rigg: a file with blocks [[device]] has a table [rig] "
                                   "too, and here is none (did you mean 'rig'?)")));
  const auto loaded = load_rig(file.string());
  ASSERT_TRUE(loaded.has_error());
  EXPECT_THAT(lines_of(loaded.error()),
              ElementsAre(EndsWith(":2:2: /rigg: expected a rig file, which has a table [rig] "
                                   "(did you mean 'rig'?)")));
  fs::remove(file);
}

TEST(Mistakes, AMisspelledFileIsComparedWithItsNeighbours) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(testing::TempDir()) / "drydock-neighbours";
  fs::create_directories(folder);
  std::ofstream(folder / "s-path.toml") << "[mission]\n";
  const auto near = [&](const char* name) { return nearest_file((folder / name).string()); };
  EXPECT_EQ(near("s-pth.toml"), " (did you mean 's-path.toml'?)");
  EXPECT_EQ(near("S-PATH.toml"), " (did you mean 's-path.toml'?)");
  EXPECT_EQ(near("s-path.toml"), "");  // it is there
  EXPECT_EQ(near("something-else.toml"), "");
  fs::remove_all(folder);
}

TEST(Mistakes, AShippedFileThatARigNamesIsWrittenBesideItFirst) {
  const std::string folder = testing::TempDir();
  EXPECT_THAT(why_no_file(folder + "nps-auv-ii", vehicles),
              EndsWith("; `drydock example vehicles/nps-auv-ii > " + folder +
                       "nps-auv-ii.toml` writes the one that comes with the program"));
  EXPECT_THAT(why_no_file(folder + "loop.toml", missions),  // a rig has the same name
              HasSubstr("; `drydock example missions/loop > " + folder + "loop.toml`"));
  EXPECT_THAT(why_no_file(folder + "nps-auvii.toml", vehicles),
              HasSubstr("(did you mean 'nps-auv-ii'?)"));
  for (const auto kind : {std::string_view{}, missions})
    EXPECT_THAT(why_no_file(folder + "nps-auv-ii.toml", kind), EndsWith("nps-auv-ii.toml"));
}

}  // namespace mistakes_test
}  // namespace drydock::rig_config::test
