#include <fmt/format.h>
#include <gmock/gmock.h>

#include "tests/drivers/guess/guessed.hpp"

/// A first description of a capture that nobody knows: sentences.
namespace drydock::described::test {
namespace guess_test {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using wire::testing::Buffer;

TEST(GuessedDescription, SentencesGiveTheirChecksumAndColumns) {
  const auto guess = guess::guess_description(wire::testing::fixture("described/valeport-vat.txt"));
  EXPECT_THAT(guess, HasSubstr("nothing here is certain"));
  EXPECT_THAT(guess, HasSubstr("checksum = \"xor\""));
  EXPECT_THAT(guess, HasSubstr("id = \"$PRVAT\""));
  EXPECT_THAT(guess, HasSubstr("{ name = \"column_1\" },  # 0 to 0.21"));
  EXPECT_THAT(guess, HasSubstr("{ text = \"M\" },"));
}

/// Sentences of an INS have 300 characters; a description reads 256 unless it says more.
TEST(GuessedDescription, OfLongSentencesSaysHowLongTheyMayBe) {
  std::string capture;
  for (int i = 0; i < 20; ++i) {
    std::string body = "INSPVAXA";
    for (int k = 0; k < 25; ++k) body += fmt::format(",{}.{:09}", i, 1000 * k + i);
    unsigned sum = 0;
    for (const char c : body) sum ^= static_cast<unsigned char>(c);
    capture += fmt::format("${}*{:02X}\r\n", body, sum);
  }
  const auto bytes = wire::testing::as_bytes(capture);
  const auto guess = guess::guess_description(bytes);
  EXPECT_THAT(guess, HasSubstr("longest = 512"));
  const auto description = described(guess);
  EXPECT_EQ(wire::described::scan(description->plan, bytes).kind, wire::Scan::Kind::frame);
}

TEST(GuessedDescription, IsADescriptionAsItStands) {
  const auto guess =
      guess::guess_description(wire::testing::fixture("described/cerulean-dvpdl.txt"));
  EXPECT_THAT(problems_of(guess), IsEmpty()) << guess;
}

TEST(GuessedDescription, WithAFieldNamedItIsADescription) {
  const auto guess =
      measured(guess::guess_description(wire::testing::fixture("described/cerulean-dvpdl.txt")),
               "name = \"column_9\"", "field = \"depth_m\", unit = \"m\"");
  EXPECT_THAT(problems_of(guess), IsEmpty()) << guess;
}

TEST(GuessedDescription, SentencesNeedNoChecksum) {
  std::string all;
  for (int i = 0; i < 9; ++i) all += fmt::format("$ALT,{}.25,m\r\n", i);
  const auto guess = guess::guess_description(wire::testing::as_bytes(all));
  EXPECT_THAT(guess, HasSubstr("checksum = \"none\""));
  EXPECT_THAT(guess, HasSubstr("{ name = \"column_1\" },  # 0.25 to 8.25"));
}

TEST(GuessedDescription, LettersBetweenTheNumbersOfASentenceEndItsFields) {
  const auto guess = guess::guess_description(
      wire::testing::as_bytes("$C320.5P0.2R-18.3T20.1*37\r\n$C0.5P-1.2R18.3T20.0*36\r\n"
                              "$C7.0P0.0R0.1T19.9*22\r\n"));
  EXPECT_THAT(guess, HasSubstr("head = \"$C\""));
  EXPECT_THAT(guess, HasSubstr("{ name = \"column_1\", ends = \"P\" },  # 0.5 to 320.5"));
  EXPECT_THAT(guess, HasSubstr("{ name = \"column_4\" },  # 19.9 to 20.1"));
  EXPECT_THAT(problems_of(guess), IsEmpty()) << guess;
}

/// The checksum is the XOR of all bytes before the '*'.
TEST(GuessedDescription, ASentenceNeedNotBeginWithADollar) {
  const auto guess = guess::guess_description(
      wire::testing::as_bytes("PRS 12.000,8.00*56\r\nPRS 12.176,8.06*50\r\nPRS -1.5,9.00*4D\r\n"));
  EXPECT_THAT(guess, HasSubstr("head = \"PRS\""));
  EXPECT_THAT(guess, HasSubstr("checksum = \"xor\"\nchecksum_from = 0"));
  EXPECT_THAT(guess, HasSubstr("{ name = \"column_1\", ends = \",\" },  # -1.5 to 12.176"));
  EXPECT_THAT(problems_of(guess), IsEmpty()) << guess;
}

/// Two ids in two forms each, an id that is none, more columns than a description has, an
/// empty column, letters that are not of ASCII.
TEST(GuessedDescription, IsADescriptionWhateverTheSentencesAre) {
  std::string all = "$ok $PXYZ,1\r\n# stray\r\n$PWORD\r\n$PDEG,12.5 \xB0,\r\n";
  for (int i = 0; i < 9; ++i) {
    all += fmt::format("$PAB,{0},,M\r\n$PAB,{0}\r\n$PCD,{0},K\r\n$PCD,{0}\r\n", i);
    all += "$PLONG";
    for (int n = 0; n < 40; ++n) all += fmt::format(",{}", i + n);
    all += "\r\n";
  }
  const auto guess = guess::guess_description(wire::testing::as_bytes(all));
  EXPECT_THAT(guess, HasSubstr("name = \"PAB_2\""));
  EXPECT_THAT(guess, HasSubstr("name = \"PCD_2\""));
  EXPECT_THAT(guess, HasSubstr("# always empty"));
  EXPECT_THAT(guess, HasSubstr("# 9 times: $PLONG,0,1,2"));
  EXPECT_THAT(guess, HasSubstr("# 1 times: $ok $PXYZ,1"));
  EXPECT_THAT(problems_of(guess), IsEmpty()) << guess;
}

TEST(GuessedDescription, NoiseGivesNothing) {
  Buffer noise(4096);
  std::uint32_t word = 1;
  for (auto& byte : noise) {
    word = word * 1664525u + 1013904223u;
    byte = static_cast<std::uint8_t>(word >> 24);
  }
  EXPECT_THAT(guess::guess_description(noise), IsEmpty());
  EXPECT_THAT(guess::guess_description({}), IsEmpty());
}

}  // namespace guess_test
}  // namespace drydock::described::test
