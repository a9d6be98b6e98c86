#include "drivers/survey/byte_survey.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <random>

#include "tests/drivers/property.hpp"
#include "tests/drivers/wire/byte_streams.hpp"

namespace drydock::survey {
namespace byte_survey_test {

using testing::ElementsAre;
using wire::testing::as_bytes;
using wire::testing::Buffer;
using wire::testing::fixture;
using wire::testing::operator+;

/// Surveys a line at 115200 baud.
ByteSurvey hear(const Buffer& line) {
  ByteSurvey survey;
  Stamp now{};
  wire::Bytes rest = line;
  while (!rest.empty()) {
    const auto piece = rest.first(std::min<std::size_t>(64, rest.size()));
    now += std::chrono::nanoseconds{86'806} * piece.size();
    survey.feed(piece, now);
    rest = rest.subspan(piece.size());
  }
  survey.finish();
  return survey;
}

Buffer noise(std::size_t size, unsigned seed = 1) {
  std::mt19937 random(seed);
  Buffer bytes(size);
  for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random());
  return bytes;
}

struct Golden {
  std::string protocol, file;
};

/// Bytes from other software, three times, so that each protocol has enough frames.
Buffer line_of(const std::string& file) {
  const Buffer once = fixture(file);
  return once + once + once;
}

class GoldenLine : public testing::TestWithParam<Golden> {};

TEST_P(GoldenLine, IsFoundAsItself) {
  const auto best = hear(line_of(GetParam().file)).best();
  EXPECT_EQ(best.protocol, GetParam().protocol);
  EXPECT_EQ(best.confidence, Confidence::certain) << reasons(best);
}

TEST_P(GoldenLine, IsFoundBehindGarbage) {
  const auto best = hear(noise(3000) + line_of(GetParam().file)).best();
  EXPECT_EQ(best.protocol, GetParam().protocol);
  EXPECT_EQ(best.confidence, Confidence::certain) << reasons(best);
}

TEST_P(GoldenLine, IsNothingWithItsBitsTurned) {
  // Simulates a wrong baud rate: bits of neighbouring bytes mix.
  Buffer line = line_of(GetParam().file);
  std::uint8_t carry = 0;
  for (auto& byte : line) {
    const std::uint8_t was = byte;
    byte = static_cast<std::uint8_t>((byte << 3 | carry) ^ 0x55);
    carry = static_cast<std::uint8_t>(was >> 5);
  }
  EXPECT_LT(hear(line).best().confidence, Confidence::likely);
}

INSTANTIATE_TEST_SUITE_P(
    Registry, GoldenLine,
    testing::Values(Golden{"nmea0183", "nmea0183/golden.nmea"}, Golden{"ubx", "ubx/golden.ubx"},
                    Golden{"pd0", "pd0/golden.pd0"}, Golden{"pd4", "pd4/golden.pd4"},
                    Golden{"pd5", "pd5/golden.pd5"}, Golden{"pd6", "pd6/golden.pd6"},
                    Golden{"water-linked", "water-linked/golden.txt"},
                    Golden{"water-linked-json", "water-linked-json/golden.jsonl"},
                    Golden{"nortek", "nortek/golden.nmea"},
                    Golden{"nortek-ad2cp", "nortek-ad2cp/golden.nortek-ad2cp"},
                    Golden{"wayfinder", "wayfinder/golden.wayfinder"}),
    [](const auto& golden) {
      std::string name = golden.param.protocol;
      std::erase(name, '-');
      return name;
    });

TEST(ByteSurvey, AReceiverWithBothProtocolsIsFoundAsSuch) {
  const auto best = hear(fixture("ubx/golden.ubx") + fixture("nmea0183/golden.nmea")).best();
  EXPECT_EQ(best.protocol, "ubx+nmea0183");
}

TEST(ByteSurvey, AnAdaptersLineIsFoundAsACarrierOfFrames) {
  std::string line;
  for (int i = 0; i < 20; ++i) line += "t18181122334455667788\r";
  const auto best = hear(as_bytes(line)).best();
  EXPECT_EQ(best.protocol, "slcan");
  EXPECT_EQ(best.confidence, Confidence::certain);
}

TEST(ByteSurvey, TheKindsOfSensorsAreThoseThatMeasure) {
  const auto survey =
      hear(as_bytes("$VDVHW,,T,,M,-0.08,N,-0.15,K*4B\r\n"
                    "$VDVBW,-0.08,,A,,,V,,V,,V*7D\r\n"
                    "$VDVHW,,T,,M,-0.08,N,-0.15,K*4B\r\n"));
  const auto best = survey.best();
  ASSERT_EQ(best.sensors.size(), 1u);
  EXPECT_EQ(best.sensors.front().kind, Kind::emlog);
}

TEST(ByteSurvey, RatesFollowTheStampsOfTheLine) {
  ByteSurvey survey;
  for (int i = 0; i < 20; ++i)
    survey.feed(as_bytes("$VDVHW,,T,,M,-0.08,N,-0.15,K*4B\r\n"),
                Stamp{} + std::chrono::milliseconds{500} * i);
  const auto best = survey.best();
  ASSERT_EQ(best.messages.size(), 1u);
  EXPECT_NEAR(*best.messages[0].rate_hz, 2, 1e-9);
  EXPECT_NEAR(*best.sensors.at(0).rate_hz, 2, 1e-9);
  EXPECT_TRUE(survey.settled());
}

TEST(ByteSurvey, AnAnswerOfCarriageReturnsIsNoAdapter) {
  EXPECT_EQ(hear(Buffer(500, '\r')).best().confidence, Confidence::nothing);
}

TEST(ByteSurvey, TextWithoutChecksumsIsNothing) {
  std::string text;
  for (int i = 0; i < 200; ++i) text += "login: Debian GNU/Linux 12 bench ttyS0\r\n";
  EXPECT_EQ(hear(as_bytes(text)).best().confidence, Confidence::nothing);
}

TEST(ByteSurvey, RandomBytesNeverGiveAConfidentAnswer) {
  EXPECT_TRUE(holds([] {
    const auto seed = *rc::gen::arbitrary<unsigned>();
    const auto size = *rc::gen::inRange<std::size_t>(0, 20'000);
    RC_ASSERT(hear(noise(size, seed)).best().confidence < Confidence::likely);
  }));
}

TEST(ByteSurvey, RandomPrintableLinesNeverGiveAConfidentAnswer) {
  EXPECT_TRUE(holds([] {
    std::mt19937 random(*rc::gen::arbitrary<unsigned>());
    constexpr std::string_view alphabet = "$*:,.0123456789ABCDEFwrzutTPG\r\n";
    Buffer text(8000);
    for (auto& c : text) c = static_cast<std::uint8_t>(alphabet[random() % alphabet.size()]);
    RC_ASSERT(hear(text).best().confidence < Confidence::likely);
  }));
}

/// The bytes that a port without parity reads from a line with seven bits and parity.
Buffer with_parity(const Buffer& seven, bool odd) {
  Buffer eight = seven;
  for (auto& byte : eight)
    if ((std::popcount(byte) % 2 == 1) != odd) byte |= 0x80;
  return eight;
}

TEST(SevenBits, ALineWithEvenOrOddParityIsReadThroughAPortWithoutIt) {
  const Buffer line = line_of("nmea0183/golden.nmea");
  for (const bool odd : {false, true}) {
    const Buffer eight = with_parity(line, odd);
    EXPECT_EQ(seven_bits(eight, odd), line);
    EXPECT_TRUE(seven_bits(eight, !odd).empty());
    EXPECT_LT(hear(eight).best().confidence, Confidence::likely);
  }
}

/// A live line that has not ended: ensembles at 5 Hz, the third with a bit of its length turned
/// over that says 8192 bytes more.
TEST(ByteSurvey, ADamagedLengthNeitherHidesNorMistimesWhatFollows) {
  Buffer ensemble = fixture("pd0/golden.pd0");
  ensemble.resize((ensemble.at(2) | ensemble.at(3) << 8) + 2U);
  ByteSurvey survey;
  for (int i = 0; i < 12; ++i) {
    Buffer sent = ensemble;
    if (i == 2) sent[3] = static_cast<std::uint8_t>(sent[3] ^ 1U << 5);
    survey.feed(sent, Stamp{std::chrono::milliseconds{200 * i}});
  }
  const auto best = survey.best();
  EXPECT_EQ(best.protocol, "pd0");
  EXPECT_EQ(best.proofs, 11U);
  ASSERT_EQ(best.messages.size(), 1U);
  EXPECT_NEAR(best.messages[0].rate_hz.value(), 10 / 2.2, 1e-9);  // ten intervals in 2.2 s
}

}  // namespace byte_survey_test
}  // namespace drydock::survey
