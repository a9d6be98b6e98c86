#include <fmt/format.h>
#include <gmock/gmock.h>

#include "drivers/guess/guess.hpp"
#include "tests/drivers/described/support.hpp"

/// A first description of a capture that nobody knows.
namespace drydock::described::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using wire::testing::Buffer;

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, text.npos) << text;
  return at == text.npos ? text : text.replace(at, from.size(), to);
}

/// With a column that is measured, and so with the kind of sensor that measures it.
std::string measured(std::string text, const std::string& from, const std::string& to) {
  return replaced(replaced(std::move(text), from, to), "# kind = ", "kind = ");
}

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

/// Forty frames A5 5A, a counter, a float that rises, a constant, CRC-16/MODBUS low byte first.
Buffer unknown_frames() {
  Buffer all{0x11, 0x22, 0x33};  // the capture begins inside a frame
  for (int i = 0; i < 40; ++i) {
    Buffer frame{0xA5, 0x5A, static_cast<std::uint8_t>(i + 250)};
    const float value = 10.0F + 0.37F * static_cast<float>(i);
    std::array<std::uint8_t, 4> raw{};
    std::memcpy(raw.data(), &value, 4);
    frame.insert(frame.end(), raw.begin(), raw.end());
    frame.push_back(0x77);
    unsigned crc = 0xFFFF;
    for (const unsigned byte : frame) {
      crc ^= byte;
      for (int bit = 0; bit < 8; ++bit) crc = crc & 1 ? crc >> 1 ^ 0xA001 : crc >> 1;
    }
    frame.push_back(static_cast<std::uint8_t>(crc));
    frame.push_back(static_cast<std::uint8_t>(crc >> 8));
    all.insert(all.end(), frame.begin(), frame.end());
  }
  return all;
}

TEST(GuessedDescription, FramesGiveLengthChecksumCounterAndFloat) {
  const auto guess = guess::guess_description(unknown_frames());
  EXPECT_THAT(guess, HasSubstr("sync = \"A5 5A\"\nlength = 10\n"));
  EXPECT_THAT(guess, HasSubstr("checksum = \"crc-16/modbus\""));
  EXPECT_THAT(guess, HasSubstr("name = \"counter_2\""));
  EXPECT_THAT(guess, HasSubstr("{ at = 3, type = \"f32\", name = \"at_3\" },  # 10 to 24.43"));
  EXPECT_THAT(guess, HasSubstr("byte 7: always 119 (0x77)"));
  const auto named = measured(guess, "name = \"at_3\"", "field = \"depth_m\", unit = \"m\"");
  const auto description = described(named);
  const Buffer stream = unknown_frames();
  EXPECT_EQ(wire::described::scan(description->plan, wire::Bytes(stream).subspan(3)),
            wire::Scan::frame(10));
}

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

TEST(GuessedDescription, SentencesNeedNoChecksum) {
  std::string all;
  for (int i = 0; i < 9; ++i) all += fmt::format("$ALT,{}.25,m\r\n", i);
  const auto guess = guess::guess_description(wire::testing::as_bytes(all));
  EXPECT_THAT(guess, HasSubstr("checksum = \"none\""));
  EXPECT_THAT(guess, HasSubstr("{ name = \"column_1\" },  # 0.25 to 8.25"));
}

/// VectorNav's binary message of yaw, pitch and roll: CRC-16/XMODEM behind the sync byte, high byte
/// first (VN-100 user manual). The CRC of "123456789" is 31C3h.
TEST(GuessedDescription, AChecksumMayBeginBehindTheSync) {
  Buffer all;
  for (int i = 0; i < 40; ++i) {
    Buffer frame{0xFA, 0x01, 0x08, 0x00};
    for (const float angle : {-120.3F + 0.7137F * static_cast<float>(i), 3.1F, -1.2F}) {
      std::array<std::uint8_t, 4> raw{};
      std::memcpy(raw.data(), &angle, 4);
      frame.insert(frame.end(), raw.begin(), raw.end());
    }
    unsigned crc = 0;
    for (const unsigned byte : wire::Bytes(frame).subspan(1)) {
      crc ^= byte << 8;
      for (int bit = 0; bit < 8; ++bit)
        crc = (crc & 0x8000 ? crc << 1 ^ 0x1021 : crc << 1) & 0xFFFF;
    }
    frame.push_back(static_cast<std::uint8_t>(crc >> 8));
    frame.push_back(static_cast<std::uint8_t>(crc));
    all.insert(all.end(), frame.begin(), frame.end());
  }
  const auto guess = guess::guess_description(all);
  EXPECT_THAT(
      guess,
      HasSubstr("checksum = \"crc-16/xmodem\"\nchecksum_order = \"big\"\nchecksum_from = 1\n"));
  EXPECT_THAT(guess,
              HasSubstr("{ at = 4, type = \"f32\", name = \"at_4\" },  # -120.3 to -92.4657"));
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

}  // namespace
}  // namespace drydock::described::test
