#include <gmock/gmock.h>

#include <map>
#include <regex>

#include "drivers/terminal/exit_codes.hpp"
#include "tests/hil/program/program.hpp"

/// The help, the manual page and docs/use/run.md have the same list of exit codes.
namespace program {
namespace exit_codes_test {

using Codes = std::map<int, std::string>;

/// The matches of a pattern with a number and a text.
Codes codes_in(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  Codes codes;
  for (std::sregex_iterator i(text.begin(), text.end(), regex), end; i != end; ++i)
    codes[std::stoi((*i)[1])] = (*i)[2];
  return codes;
}

Codes of_the_program() {
  Codes codes;
  for (const auto& [code, meaning] : drydock::terminal::exit_codes) codes[code] = meaning;
  return codes;
}

/// From "Exit codes:" to the next line that begins a paragraph, on one line.
std::string paragraph_of_codes(const std::string& help) {
  std::string text = help.substr(help.find("Exit codes:"));
  text = text.substr(0, text.find('.'));
  return std::regex_replace(text, std::regex("\\s+"), " ");
}

TEST(ExitCodes, TheHelpNamesEachOfThem) {
  const auto help = drydock("--help");
  EXPECT_EQ(codes_in(paragraph_of_codes(help.output), "[:,] ([0-9]+) ([^,]+)"), of_the_program());
}

TEST(ExitCodes, TheManualPageNamesEachOfThem) {
  const auto page = drydock("man").output;
  EXPECT_EQ(codes_in(page.substr(page.find("EXIT STATUS")), "\\.B ([0-9]+)\\n([^\\n]+)\\n"), [] {
    Codes roff = of_the_program();
    for (auto& [code, meaning] : roff)
      meaning = std::regex_replace(meaning, std::regex("-"), "\\-");
    return roff;
  }());
}

TEST(ExitCodes, ThePageOfRunHasARowForEachOfThem) {
  const std::string page = read_file(DRYDOCK_SOURCE_DIR "/docs/use/run.md");
  const std::string section = page.substr(page.find("## Exit codes of every command"));
  const auto rows =
      codes_in(section.substr(0, section.find("\n## ")), "\\| ([0-9]+) \\| ([^:|]+)(:[^|]*)? \\|");
  const auto codes = of_the_program();
  ASSERT_EQ(rows.size(), codes.size());
  for (const auto& [code, meaning] : codes) {
    ASSERT_TRUE(rows.contains(code)) << code;
    EXPECT_EQ(rows.at(code), meaning);
  }
}

TEST(ExitCodes, AConfigurationThatCannotRunIsTwoInEveryCommand) {
  const Folder folder;
  const std::string rig = (folder / "rig.toml").string();
  std::ofstream(rig) << "[rig]\nname = \"x\"\n[[device]]\nname = \"imu\"\nkind = \"imu\"\n"
                        "protocol = \"aceinna\"\nlink = \"memory-can:bus\"\n"
                        "aceinna = { packet_rate_hz = 30 }\n";
  for (const char* command : {"check", "run --for 1s", "run --for 1s --speed max", "drive --for 1s",
                              "emulate --for 1s", "estimate --for 1s", "scorecard"}) {
    const auto refused = drydock(std::string(command) + " " + rig);
    EXPECT_EQ(refused.exit_code, drydock::terminal::exit_usage) << command;
    EXPECT_THAT(refused.output, testing::HasSubstr("rig.toml:8:30: /device/0/aceinna/"
                                                   "packet_rate_hz: "))
        << command;
  }
}

TEST(ExitCodes, ADomainWithoutPortsIsTwo) {
  const auto refused = drydock("--version; ROS_DOMAIN_ID=233 " DRYDOCK_PROGRAM
                               " drive rig_config/rigs/demo.toml --for 1s");
  EXPECT_EQ(refused.exit_code, drydock::terminal::exit_usage);
  EXPECT_THAT(refused.output, testing::HasSubstr("ROS_DOMAIN_ID is '233'; allowed: 0 to 232"));
}

}  // namespace exit_codes_test
}  // namespace program
