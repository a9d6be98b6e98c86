// `-` in the place of a file is standard output, in every command that takes a file of JSON.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "tests/hil/program/program.hpp"

namespace dash_test {

using program::drydock;
using program::Folder;
using testing::HasSubstr;

#define DEMO "rig_config/rigs/demo.toml"
#define DIVE "fixtures/dives/dvl-finds-the-bottom/dive.mcap"

/// Little work for each command that takes --json FILE; @ stands for its value.
const std::map<std::string, std::string> work{
    {"run", DEMO " --for 1s --speed max --json @"},
    {"replay", DIVE " --quiet --json @"},
    {"study", "mixing --runs 1 --json @"},
    {"scorecard", DEMO " --devices emlog --faults hang --warm-up 2s --fault-for 1s --after 1s "
                       "--json @"},
    {"characterize", DIVE " --device dvl --json @"},
    {"soak", "rig_config/rigs/soak.toml --for 1min --json @"},
    {"load", DEMO " --for 1s --json @"},
    {"validity", DEMO " --for 2s --speed max --json @"},
};

/// By the help of each command.
std::set<std::string> commands_with_json_file() {
  std::set<std::string> names;
  std::istringstream words(drydock("help").output);
  const std::regex entry("^  ([a-z][a-z-]*) +[A-Z].*"), option("--json +TEXT");
  for (std::string line; std::getline(words, line);)
    if (std::smatch found; std::regex_match(line, found, entry))
      if (std::regex_search(drydock(found[1].str() + " --help").output, option))
        names.insert(found[1]);
  return names;
}

/// Standard output alone.
std::string piped(const std::string& command) {
  return drydock(command + " 2>/dev/null | cat").output;
}

TEST(ADash, IsTriedOnEveryCommandThatTakesAFileOfJson) {
  std::set<std::string> tried;
  for (const auto& [name, arguments] : work) tried.insert(name);
  EXPECT_EQ(commands_with_json_file(), tried);
}

TEST(ADash, GivesTheJsonAloneOnStandardOutput) {
  for (auto [name, arguments] : work) {
    const auto out = piped(name + " " + arguments.replace(arguments.find('@'), 1, "-"));
    const auto json = nlohmann::json::parse(out, nullptr, false);
    EXPECT_TRUE(json.is_object() || json.is_array()) << name << "\n" << out.substr(0, 300);
    EXPECT_FALSE(std::filesystem::exists(DRYDOCK_SOURCE_DIR "/-")) << name;
  }
}

TEST(ADash, GivesTheBytesOfTheFileAndLeavesTheRestToStandardError) {
  const Folder folder;
  const auto file = (folder / "turn.csv").string();
  const std::string turn =
      "maneuver rig_config/vehicles/nps-auv-ii.toml turning-circle --json --csv ";
  drydock(turn + file);
  EXPECT_EQ(piped(turn + "-"), program::read_file(file));
  EXPECT_THAT(drydock(turn + "- > /dev/null; }", "{").output, HasSubstr("steady_roll_deg"));
}

TEST(ADash, IsAppendedToAFileThatHasSomething) {
  const Folder folder;
  const auto file = (folder / "log").string();
  std::ofstream(file) << "before\n";
  drydock("replay " DIVE " --quiet --json - 2>/dev/null >> " + file + "; true");
  EXPECT_THAT(program::read_file(file), testing::StartsWith("before\n{"));
}

TEST(ADash, MayBeOneFileOnly) {
  const auto refused = drydock("run " DEMO " --for 1s --speed max --json - --junit -");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.output, HasSubstr("- is standard output, which one file may be"));
}

TEST(ADash, OnAFullDiskIsToldAsStandardOutputIs) {
  const auto full = drydock("replay " DIVE " --quiet --json - > /dev/full; }", "{");
  EXPECT_EQ(full.exit_code, 1);
  EXPECT_THAT(full.output, HasSubstr("standard output cannot be written: No space left"));
}

}  // namespace dash_test
