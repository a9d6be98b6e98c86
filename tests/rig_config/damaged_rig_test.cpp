#include "tests/rig_config/problems.hpp"

#include <rapidcheck/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>

/// Damaged rig files, and files that are not rig files.
namespace drydock::rig_config::test {
namespace damaged_rig_test {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(DamagedRig, StartIsADateTimeWithAnOffset) {
  const std::string device(dvl_table);
  EXPECT_THAT(problems_of_text("[rig]\nname = \"r\"\nstart = \"2026-11-21T08:00:00Z\"\n" + device),
              ElementsAre("r.toml:3:9: /rig/start: expected a date-time without quotes such as "
                          "2026-11-21T08:00:00Z, found a string"));
  EXPECT_THAT(problems_of_text("[rig]\nname = \"r\"\nstart = 2026-11-21T08:00:00\n" + device),
              ElementsAre("r.toml:3:9: /rig/start: this date-time has no offset, write for example "
                          "2026-11-21T08:00:00Z"));
  EXPECT_THAT(problems_of_text("[rig]\nname = \"r\"\nmission = 2026-11-21T08:00:00Z\n" + device),
              ElementsAre("r.toml:3:11: /rig/mission: expected a string, found a date-time"));
}

TEST(DamagedRig, AListOrATableWhereADateTimeBelongsIsToldAndDoesNotAbort) {
  for (const std::string value : {"[]", "[[1]]", "{}", "{ a = 1 }"}) {
    const auto rig = load_rig_text("[rig]\nname = \"x\"\nstart = " + value + "\n", "r.toml");
    ASSERT_FALSE(rig) << value;
    EXPECT_TRUE(std::ranges::any_of(rig.error(), [](const Problem& problem) {
      return problem.path.starts_with("/rig/start");
    })) << value;
  }
}

TEST(DamagedRig, SyntaxErrorsHaveTheSameForm) {
  EXPECT_THAT(problems_of_text("[rig]\nname = bench\n"), ElementsAre(HasSubstr("r.toml:2:")));
  EXPECT_THAT(problems_of_text("[rig]\nname = \"a\"\nname = \"b\"\n"),
              ElementsAre(HasSubstr("r.toml:3:")));
}

TEST(DamagedRig, AnotherKindOfFileIsNoRig) {
  EXPECT_THAT(problems_of_text("[mission]\n"),
              ElementsAre("r.toml:1:1: /: expected a rig file, which has a table [rig]"));
}

TEST(DamagedRig, ARigFileThatCannotBeReadIsOneLine) {
  const auto rig = load_rig("/nowhere/r.toml");
  ASSERT_FALSE(rig);
  EXPECT_THAT(lines_of(rig.error()), ElementsAre("/nowhere/r.toml: cannot be read: No such "
                                                 "file or directory"));
}

RC_GTEST_PROP(DamagedRig, NoTextMakesTheLoaderThrow, (const std::string& text)) {
  const auto rig = load_rig_text(text, "r.toml");
  RC_ASSERT(!rig);
  RC_ASSERT(!rig.error().empty());
}

/// The demo rig with one line removed or with one value exchanged. It must load or give its
/// problems.
RC_GTEST_PROP(DamagedRig, ADamagedDemoIsLoadedOrToldWhyNot, ()) {
  const std::string path = DRYDOCK_SOURCE_DIR "/rig_config/rigs/demo.toml";
  std::vector<std::string> lines;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  const auto victim = *rc::gen::inRange<std::size_t>(0, lines.size());
  const auto value = *rc::gen::element<std::string>("", "1", "-1e300", "\"\"", "[]", "{}", "true",
                                                    "[[1]]", "1979-05-27", "\"\\u0000\"");
  const auto equals = lines[victim].find('=');
  lines[victim] = value.empty() || equals == std::string::npos
                      ? ""
                      : lines[victim].substr(0, equals + 1) + value;
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  const auto rig = load_rig_text(text, path);
  if (rig) return;
  for (const Problem& problem : rig.error()) RC_ASSERT(problem.line > 0 && !problem.what.empty());
}

}  // namespace damaged_rig_test
}  // namespace drydock::rig_config::test
