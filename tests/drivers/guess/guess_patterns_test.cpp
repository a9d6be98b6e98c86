#include <fmt/format.h>
#include <gmock/gmock.h>

#include "tests/drivers/guess/guessed.hpp"

/// First descriptions of lines of text: which lines are one message, and which words are numbers.
namespace drydock::described::test {
namespace guess_patterns_test {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// How a conductivity, temperature and depth sensor streams, after a line that lost its beginning.
std::string ctd_lines() {
  std::string all = ":59.500, 42.9, 10.1, 20.0\r\n";
  for (int i = 0; i < 20; ++i)
    all += fmt::format("2026-11-24 05:00:{:02}.000, 42.91{:02}, {:.2f}, {:.1f}\r\n", i, i,
                       10.5 + 0.01 * i, 20.5 - i);
  return all;
}

TEST(GuessedDescription, LinesThatDifferInTheirNumbersAreOneMessage) {
  const auto guess = guess::guess_description(wire::testing::as_bytes(ctd_lines()));
  EXPECT_THAT(guess,
              HasSubstr("[[protocol.lines]]             # 20 times, as 2026-11-24 05:00:00"));
  EXPECT_THAT(guess, HasSubstr("column_8\", decimals = 2 },  # 10.5 to 10.69"));
  EXPECT_THAT(guess, HasSubstr("column_9\", decimals = 1 },  # 1.5 to 20.5"));
  const auto toy =
      described(measured(guess, "name = \"column_9\"", "field = \"pressure_pa\", unit = \"dbar\""));
  wire::described::Record record;
  const auto line = wire::testing::as_bytes("2026-11-25 06:10:00.000, 42.9, -0.05, 33.25\r\n");
  ASSERT_EQ(wire::described::decode(toy->plan, line, record), wire::described::Decoded::message);
  EXPECT_DOUBLE_EQ(value_of(record, "pressure_pa"), 332'500);
  EXPECT_DOUBLE_EQ(value_of(record, "column_8"), -0.05);
}

TEST(GuessedDescription, LinesWithOtherWordsAreMessagesOfTheirOwn) {
  std::string all = "stray\n";
  for (int i = 0; i < 9; ++i) all += fmt::format("T1={}.5C\tok\nDepth 'top' {} m\n", i, i - 4);
  const auto guess = guess::guess_description(wire::testing::as_bytes(all + "Depth failed\n"));
  EXPECT_THAT(guess, HasSubstr("head = \"T1=\""));
  EXPECT_THAT(guess, HasSubstr("head = \"Depth 'top' \""));
  EXPECT_THAT(guess, HasSubstr("emulate = \"{c1}C\\tok\""));  // it stands behind the head
  EXPECT_THAT(guess, HasSubstr("# Not described:\n# 1 times: Depth failed\n"));
  EXPECT_THAT(
      problems_of(measured(guess, "name = \"column_1\"", "field = \"depth_m\", unit = \"m\"")),
      IsEmpty())
      << guess;
}

TEST(GuessedDescription, LinesThatNoPatternHoldsAreNamed) {
  std::string all = "stray\n";
  for (int i = 0; i < 9; ++i) {
    all += std::string(40, 'h') + fmt::format(" {} +{}.5\n", i, i);
    for (int n = 0; n < 30; ++n) all += fmt::format("{} value ", n + i);
    all += "\n";
  }
  const auto guess = guess::guess_description(wire::testing::as_bytes(all));
  EXPECT_THAT(guess, HasSubstr("head = \"" + std::string(32, 'h') + "\""));
  EXPECT_THAT(guess, HasSubstr("# Not described:\n# 9 times: 0 value 1 value"));
  EXPECT_THAT(
      problems_of(measured(guess, "name = \"column_2\"", "field = \"depth_m\", unit = \"m\"")),
      IsEmpty())
      << guess;
}

TEST(GuessedDescription, ALineMayHavePowersOfTenAndManyDecimals) {
  std::string all = "stray\n";
  for (int i = 0; i < 9; ++i) all += fmt::format("{}.5,1.25e-0{},0.{}23456789012345\n", i, i, i);
  all += "12.5 \xB0\n";
  const auto guess = guess::guess_description(wire::testing::as_bytes(all));
  EXPECT_THAT(guess, HasSubstr("# 9 times, as 0.5,1.25e-00,"));
  EXPECT_THAT(guess, HasSubstr("# 1.25e-08 to 1.25"));
  EXPECT_THAT(guess, HasSubstr("# 1 times: 12.5 ."));
  EXPECT_THAT(problems_of(guess), IsEmpty()) << guess;
}

/// Degree signs in Latin-1 and in UTF-8, and a head that ends with one.
TEST(GuessedDescription, ADegreeSignMakesNoBinaryProtocolOfALine) {
  for (const std::string sign : {"\xB0", "\xC2\xB0"}) {
    std::string all = "stray\n";
    for (int i = 0; i < 20; ++i)
      all += fmt::format("H{0} {1:5.1f}{0} T {2:+.2f}{0}C\r\n", sign, 7.5 * i, i - 9.25);
    const auto guess = guess::guess_description(wire::testing::as_bytes(all));
    EXPECT_THAT(guess, HasSubstr("[[protocol.lines]]             # 20 times"));
    EXPECT_THAT(guess, HasSubstr("column_2\", decimals = 2 },  # -9.25 to 9.75"));
    const auto toy = described(
        measured(guess, "name = \"column_2\"", "field = \"temperature_k\", unit = \"degC\""));
    wire::described::Record record;
    const auto line =
        wire::testing::as_bytes("H" + sign + " 359.9" + sign + " T -1.75" + sign + "C\r\n");
    ASSERT_EQ(wire::described::decode(toy->plan, line, record), wire::described::Decoded::message);
    EXPECT_DOUBLE_EQ(value_of(record, "temperature_k"), 271.4);
  }
}

/// As "%6.1f" and "%7.2f" write them.
TEST(GuessedDescription, NumbersThatAreFilledUpWithBlanksAreOneMessage) {
  std::string all = "stray\n";
  for (int i = 0; i < 30; ++i)
    all += fmt::format("A={:6.1f} B {:7.2f} m\n", 40.0 * i - 90, 9.5 * i);
  const auto guess = guess::guess_description(wire::testing::as_bytes(all));
  EXPECT_THAT(guess, HasSubstr("[[protocol.lines]]             # 30 times"));
  EXPECT_THAT(guess, Not(HasSubstr("Not described")));
  EXPECT_THAT(guess, HasSubstr("head = \"A=\""));
  const auto toy =
      described(measured(guess, "name = \"column_2\"", "field = \"depth_m\", unit = \"m\""));
  for (const auto& [text, depth_m] :
       {std::pair{"A=  -0.5 B   12.25 m\n", 12.25}, std::pair{"A=1234.5 B 1000.00 m\n", 1000.0}}) {
    wire::described::Record record;
    ASSERT_EQ(wire::described::decode(toy->plan, wire::testing::as_bytes(text), record),
              wire::described::Decoded::message);
    EXPECT_DOUBLE_EQ(value_of(record, "depth_m"), depth_m);
  }
}

/// What the guess of these lines finds in the second column of another line.
double second_column(const std::string& lines, const std::string& line) {
  const auto guess = guess::guess_description(wire::testing::as_bytes("stray\n" + lines));
  EXPECT_THAT(guess, Not(HasSubstr("Not described"))) << guess;
  const auto toy =
      described(measured(guess, "name = \"column_2\"", "field = \"depth_m\", unit = \"m\""));
  wire::described::Record record;
  const auto bytes = wire::testing::as_bytes(line);
  EXPECT_EQ(wire::described::decode(toy->plan, bytes, record), wire::described::Decoded::message)
      << guess;
  return value_of(record, "depth_m");
}

TEST(GuessedDescription, ASignBehindALetterBelongsToTheNumber) {
  std::string lines;
  for (int i = 0; i < 20; ++i) lines += fmt::format("D{:+07.2f} M{:+06.1f}\n", i - 9.75, 4.5 - i);
  EXPECT_DOUBLE_EQ(second_column(lines, "D-000.25 M-006.1\n"), -6.1);
}

TEST(GuessedDescription, AWordAtTheEndOfALineMayDiffer) {
  std::string lines;
  for (int i = 0; i < 20; ++i)
    lines += fmt::format("T={:.1f};{:.2f},{}\n", i + 0.5, 2.0 * i, i % 7 == 0 ? "ERR" : "OK");
  EXPECT_DOUBLE_EQ(second_column(lines, "T=1.5;-2.25,ERR\n"), -2.25);
}

TEST(GuessedDescription, WhatStandsInThePlaceOfANumberIsNone) {
  std::string lines;
  for (int i = 0; i < 20; ++i)
    lines += fmt::format("P {} T {}\n", i % 5 == 0 ? "----.-" : fmt::format("{:6.1f}", 990.0 + i),
                         i % 4 == 0 ? "NaN" : fmt::format("{:.2f}", 0.5 * i));
  EXPECT_DOUBLE_EQ(second_column(lines, "P ----.- T 3.25\n"), 3.25);
  EXPECT_DOUBLE_EQ(second_column(lines, "P 1003.0 T 7.5\n"), 7.5);
}

}  // namespace guess_patterns_test
}  // namespace drydock::described::test
