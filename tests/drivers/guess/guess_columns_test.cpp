#include <fmt/format.h>
#include <gmock/gmock.h>

#include "tests/drivers/guess/guessed.hpp"

/// First descriptions of texts whose columns are told by their place, or by the word behind the id.
namespace drydock::described::test {
namespace guess_columns_test {

using namespace wire::testing;
using ::testing::HasSubstr;
using ::testing::Not;

/// As a compass and dead reckoning unit writes heading, pitch, roll, temperature and depth.
TEST(GuessedColumns, ASignBehindTheLetterBehindANumberBelongsToTheNext) {
  const auto guess = guess::guess_description(as_bytes(lines_of(40, [](int i) {
    return fmt::format("H{:04}P{:+04}R{:+04}T+213D01234", 90 * i, 7 * i - 140, 150 - 7 * i);
  })));
  EXPECT_THAT(guess, Not(HasSubstr("Not described")));
  EXPECT_EQ(read(guess, "H0484P+108R-163T+213D01234", "column_2"), 108);
  EXPECT_EQ(read(guess, "H0484P+108R-163T+213D01234", "column_3"), -163);
}

/// TSS1: accelerations in hexadecimal digits, heave, a letter for the state, roll, pitch.
TEST(GuessedColumns, OfAFixedWidthAreToldByTheirPlace) {
  const auto guess = guess::guess_description(as_bytes(lines_of(60, [](int i) {
    const int slow = static_cast<int>(std::lround(900 * std::sin(0.3 * i)));
    return fmt::format(":{:02X}{:04X} {: 05}{}{: 05} {: 05}", 3 * i, (slow + 31 * i) & 0xFFFF, slow,
                       "UuHhF"[i % 5], 2900 - 97 * i, 13 * i - slow);
  })));
  EXPECT_THAT(guess, Not(HasSubstr("Not described")));
  ASSERT_EQ(problems_of(guess), "");
  EXPECT_THAT(guess, HasSubstr("type = \"text\""));
  EXPECT_THAT(guess,
              HasSubstr("(?P<c1>[0-9A-Fa-f]{2})(?P<c2>[0-9A-Fa-f]{4}) (?P<c3>[- ][0-9]{4})"));
  EXPECT_EQ(read(guess, ":9900BF -0127F 0797 -2940", "column_3"), -127);
  EXPECT_EQ(read(guess, ":9900BF -0127F 0797 -2940", "column_5"), 797);
  EXPECT_EQ(read(guess, ":9900BF -0127F 0797 -2940", "column_6"), -2940);
}

TEST(GuessedColumns, OfLinesThatHoldWordsAreNotToldByTheirPlace) {
  const std::vector<std::string_view> words{"depth", "ample", "bogus", "trees", "seven"};
  std::vector<std::string> lines;
  for (int i = 0; i < 40; ++i)
    lines.push_back(fmt::format("{} {:02X}{}", words[i * 7 % 5], i, words[i * 3 % 5]));
  EXPECT_EQ(guess::guess_fixed_lines({lines.begin(), lines.end()}).lines, 0u);
}

/// iXblue: $PIXSE with the kind in its first field.
TEST(GuessedSubIds, WordsBehindTheIdArePartOfIt) {
  const auto guess = guess::guess_description(as_bytes(lines_of(60, [](int i) {
    if (i % 3 == 0) return fmt::format("$PIXSE,ATITUD,{:.3f},{:.3f}", 0.01 * i, -0.02 * i);
    return fmt::format("$PIXSE,{},{:.3f},{:.3f},0.014", i % 3 == 1 ? "SPEED_" : "HEAVE_", 0.01 * i,
                       -0.02 * i);
  })));
  for (const char* word : {"ATITUD", "SPEED_", "HEAVE_"}) {
    EXPECT_THAT(guess, HasSubstr(fmt::format("name = \"PIXSE_{}\"", word)));
    EXPECT_THAT(guess, HasSubstr(fmt::format("{{ text = \"{}\" }}", word)));
  }
  EXPECT_EQ(problems_of(guess), "");
}

/// Seapath: $PSXN,20 says the quality, $PSXN,23 roll, pitch, heading and heave.
TEST(GuessedSubIds, NumbersBehindTheIdArePartOfItWhereTheColumnsDiffer) {
  const auto guess = guess::guess_description(as_bytes(lines_of(60, [](int i) {
    return i % 2 == 0
               ? std::string("$PSXN,20,1,0,1,0")
               : fmt::format("$PSXN,23,{:.2f},{:.2f},{:.2f},0.12", 0.1 * i, 3 - 0.1 * i, 5.0 * i);
  })));
  EXPECT_THAT(guess, HasSubstr("[[protocol.sentences]]          # 30 times"));
  EXPECT_THAT(guess, HasSubstr("{ text = \"20\" }"));
  EXPECT_THAT(guess, HasSubstr("{ text = \"23\" },\n  { name = \"column_2\" },  # 0.1 to 5.9"));
  EXPECT_EQ(problems_of(guess), "");
}

TEST(GuessedSubIds, AStateIsNone) {
  const auto guess = guess::guess_description(as_bytes(lines_of(
      60, [](int i) { return fmt::format("$PALT,{},{:.2f}", i % 7 == 0 ? 'V' : 'A', 0.1 * i); })));
  EXPECT_THAT(guess, HasSubstr("# 60 times"));
  const auto numbers = guess::guess_description(as_bytes(lines_of(
      60, [](int i) { return fmt::format("$PALT,{},{:.2f}", i % 7 == 0 ? 10 : 12, 0.1 * i); })));
  EXPECT_THAT(numbers, HasSubstr("# 60 times"));
}

}  // namespace guess_columns_test
}  // namespace drydock::described::test
