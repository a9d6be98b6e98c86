#include "drivers/wire/nmea0183/nmea0183_sentence.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <rapidcheck.h>
#include <charconv>

#include "drivers/wire/nmea0183/nmea0183.hpp"
#include "tests/drivers/wire/byte_streams.hpp"

namespace drydock::wire::testing {
namespace nmea0183_sentence_test {

/// Reads the only field of a sentence. The field after it must not change.
std::optional<double> number_in(const std::string& field) {
  const Buffer frame = as_bytes("$GPXXX," + field + ",7*00\r\n");
  SentenceReader fields{frame};
  const auto value = fields.number();
  EXPECT_EQ(fields.integer(), 7);
  return value;
}

std::string digits(int least, int most) {
  const auto count = *rc::gen::inRange<std::size_t>(static_cast<std::size_t>(least),
                                                    static_cast<std::size_t>(most) + 1);
  return *rc::gen::container<std::string>(count, rc::gen::inRange('0', static_cast<char>('9' + 1)));
}

RC_GTEST_PROP(NmeaSentence, NumbersAreThoseOfTheStandardLibraryToTheLastBit, ()) {
  const std::string text = *rc::gen::element<std::string>("", "-") + digits(1, 24) +
                           *rc::gen::element<std::string>("", ".");
  const std::string field = text.ends_with('.') ? text + digits(0, 12) : text;
  double expected = 0;
  std::from_chars(field.data(), field.data() + field.size(), expected, std::chars_format::fixed);
  RC_ASSERT(number_in(field) == expected);
}

TEST(NmeaSentence, WhatIsNoPlainNumberIsReadOrRefusedAsAWhole) {
  EXPECT_EQ(number_in(" 1.5 "), 1.5);
  EXPECT_EQ(number_in("+2"), 2.0);
  EXPECT_EQ(number_in(".25"), 0.25);
  for (const auto* refused :
       {"", "-", ".", "1.2.3", "1e3", "nan", "inf", "0x1", "--1", "1-", "1 2"}) {
    EXPECT_FALSE(number_in(refused)) << refused;
  }
}

RC_GTEST_PROP(NmeaSentence, TheTextEndsAtTheFirstCharacterThatIsNone, ()) {
  // The search by eight bytes and the search byte by byte find the same position.
  const auto length = *rc::gen::inRange<std::size_t>(0, 40);
  const auto breaker = *rc::gen::arbitrary<std::uint8_t>();
  RC_PRE(breaker == '$' || breaker < 0x20 || breaker > 0x7E);
  const Buffer bytes = as_bytes("$" + std::string(length, 'A')) + Buffer{breaker} +
                       as_bytes("BBBBBBBBBBBBBBBB*00\r\n");
  RC_ASSERT(Nmea0183::scan(bytes) == Scan::skip(length + 1));
}

}  // namespace nmea0183_sentence_test
}  // namespace drydock::wire::testing
