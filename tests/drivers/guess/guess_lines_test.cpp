#include <fmt/format.h>
#include <gmock/gmock.h>

#include "tests/drivers/guess/guessed.hpp"

/// First descriptions of lines without a checksum, in forms that laboratories and sensors have.
namespace drydock::described::test {
namespace guess_lines_test {

using namespace wire::testing;
using ::testing::HasSubstr;
using ::testing::Not;
using wire::described::Decoded;
using wire::described::Record;

TEST(GuessedNumbers, WithDecimalCommasAreOneColumnEach) {
  const auto guess = guess::guess_description(as_bytes(lines_of(
      40, [](int i) { return fmt::format("D;{},{:02};{},{};OK", 12, i, 8 + i / 10, i % 10); })));
  EXPECT_THAT(guess, HasSubstr("decimal = \",\""));
  EXPECT_THAT(guess, HasSubstr("pattern = '(?P<c1>-?[0-9,]+);(?P<c2>-?[0-9,]+);OK'"));
  EXPECT_THAT(guess, HasSubstr("decimals = 2 },  # 12.01 to 12.39"));
  EXPECT_EQ(problems_of(guess), "");
}

TEST(GuessedNumbers, BetweenCommasAreNoDecimals) {
  for (const char* line : {"{},{:02},5", "{}, {:02}", "1.5 {},{:02}"}) {
    const auto guess = guess::guess_description(as_bytes(
        lines_of(40, [&](int i) { return fmt::format(fmt::runtime(line), 12 + i / 9, i); })));
    EXPECT_THAT(guess, ::testing::Not(HasSubstr("decimal ="))) << guess;
    EXPECT_EQ(problems_of(guess), "") << guess;
  }
}

/// As a CTD in its raw format: temperature, conductivity, pressure, temperature of the pressure
/// sensor in 6, 6, 6 and 4 digits.
TEST(GuessedNumbers, OfHexadecimalDigitsAreCutWhereTheirDigitsTell) {
  const auto guess = guess::guess_description(as_bytes(lines_of(60, [](int i) {
    return fmt::format("{:06X}{:06X}{:06X}{:04X}", 675441 + 3 * i, 1815879 - 5 * i, 791020 + 7 * i,
                       33381 + i);
  })));
  EXPECT_THAT(guess, HasSubstr("(?P<c1>[0-9A-Fa-f]{6})(?P<c2>[0-9A-Fa-f]{6})(?P<c3>[0-9A-Fa-f]{6})"
                               "(?P<c4>[0-9A-Fa-f]{4})"));
  ASSERT_EQ(problems_of(guess), "");
  const auto description = described(guess);
  Record line;
  ASSERT_EQ(
      wire::described::decode(description->plan, as_bytes("0A4E711BB5470C11EC8265\r\n"), line),
      Decoded::message);
  EXPECT_EQ(value_of(line, "column_1"), 675441);
  EXPECT_EQ(value_of(line, "column_4"), 33381);
}

TEST(GuessedNumbers, OfHexadecimalDigitsMayHaveAPrefix) {
  const auto guess = guess::guess_description(as_bytes(lines_of(
      40, [](int i) { return fmt::format(">{:04X}{:04X}5A", 0x2BA0 + i, 0x7C00 + 3 * i); })));
  EXPECT_THAT(guess, HasSubstr("head = \">\"\npattern = '(?P<c1>[0-9A-Fa-f]{4})"));
  EXPECT_EQ(problems_of(guess), "");
}

TEST(GuessedNumbers, BehindZeroXAreHexadecimal) {
  const auto guess = guess::guess_description(as_bytes(
      lines_of(80, [](int i) { return fmt::format("{:.2f},0x{:02X},{}", 0.1 * i, i, i); })));
  EXPECT_THAT(guess, HasSubstr("(?P<c1>-?[0-9.]+),0x(?P<c2>[0-9A-Fa-f]+),(?P<c3>-?[0-9.]+)"));
  EXPECT_THAT(guess, HasSubstr("name = \"column_2\", type = \"hex\", width = 2 },  # 1 to 79"));
  EXPECT_EQ(problems_of(guess), "");
}

/// ISO 8601: the hour stands behind a T, and a capture of a few minutes has only one.
TEST(GuessedNumbers, OfATimeAreColumnsThoughTheHourNeverChanged) {
  const auto guess = guess::guess_description(as_bytes(lines_of(
      40, [](int i) { return fmt::format("2014-08-01T00:{:02}:05Z,{:.1f}", i, 10 + 0.3 * i); })));
  ASSERT_EQ(problems_of(guess), "") << guess;
  const auto description = described(guess);
  Record line;
  EXPECT_EQ(
      wire::described::decode(description->plan, as_bytes("2014-08-01T01:02:05Z,13.5\r\n"), line),
      Decoded::message)
      << guess;
}

/// Every line of `count` is a message of the description that is guessed from them.
void expect_all_described(const std::string& lines, int count) {
  const auto guess = guess::guess_description(as_bytes(lines));
  ASSERT_EQ(problems_of(guess), "") << guess;
  const auto description = described(guess);
  int read = 0;
  std::string_view rest = lines;
  while (!rest.empty()) {
    const auto end = rest.find('\n') + 1;
    Record record;
    read += wire::described::decode(description->plan, as_bytes(rest.substr(0, end)), record) ==
            Decoded::message;
    rest.remove_prefix(end);
  }
  EXPECT_EQ(read, count) << guess;
}

TEST(GuessedWords, InTheMiddleOfALineAreValuesOfOneMessage) {
  expect_all_described(lines_of(60,
                                [](int i) {
                                  return fmt::format(R"({{"depth":{:.3f},"ok":{},"t":{}}})",
                                                     10 + 0.01 * i, i % 7 != 0, 1700000000 + i);
                                }),
                       60);
  expect_all_described(lines_of(60,
                                [](int i) {
                                  return fmt::format("D{:.2f},{},{:.1f}", 10 + 0.01 * i,
                                                     i % 3 == 0 ? 'A' : 'V', 20 - 0.1 * i);
                                }),
                       60);
  expect_all_described(
      lines_of(60, [](int i) { return fmt::format("D{:06.2f},{}", 0.01 * i, i % 2 ? '+' : '-'); }),
      60);
}

TEST(GuessedWords, AtANumberAreItsNameAndMakeAnotherMessage) {
  const auto guess = guess::guess_description(as_bytes(lines_of(80, [](int i) {
    return i % 2 == 0 ? fmt::format(R"({{"id":{},"depth":{:.2f}}})", i, 0.1 * i)
                      : fmt::format(R"({{"id":{},"temp":{:.2f}}})", i, 20 - 0.1 * i);
  })));
  EXPECT_THAT(guess, Not(HasSubstr("|"))) << "depth and temperature in one column";
  EXPECT_THAT(guess, HasSubstr("# Not described:"));
}

TEST(GuessedWords, OfNestedBracketsAreWrittenAsTheyCame) {
  expect_all_described(lines_of(60,
                                [](int i) {
                                  return fmt::format(R"({{"a":{:.2f},"b":{{"c":{},"s":"{}"}}}})",
                                                     0.1 * i, i, i % 5 ? "ok" : "bad");
                                }),
                       60);
}

}  // namespace guess_lines_test
}  // namespace drydock::described::test
