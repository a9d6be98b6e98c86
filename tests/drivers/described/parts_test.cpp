#include <gmock/gmock.h>

#include <numbers>

#include "tests/drivers/described/decoded.hpp"

/// Values that a message says in several fields.
namespace drydock::described::test {
namespace parts_test {

using namespace wire::testing;
using ::testing::HasSubstr;
using wire::described::Readings;
using wire::described::Target;

constexpr double degree = std::numbers::pi / 180;

/// Degrees, minutes and seconds in three columns, the time of day in hours and minutes.
const std::string columns = R"(
[sensor]
title = "toy"
kind = "gnss"
[protocol]
[[protocol.sentences]]
id = "$PFIX"
fields = [
  { field = "time_s", unit = "h", decimals = 0 },
  { name = "minutes", unit = "min", adds_to = "time_s", decimals = 3 },
  { field = "latitude_deg", unit = "deg", decimals = 0 },
  { name = "latitude_min", unit = "arcmin", adds_to = "latitude_deg", decimals = 4 },
  { field = "longitude_deg", unit = "deg", decimals = 0 },
  { name = "longitude_min", unit = "arcmin", adds_to = "longitude_deg", decimals = 4 },
  { sign_of = "longitude_deg", plus = "E", minus = "W" },
]
)";

Buffer sentence(const std::string& body) {
  unsigned sum = 0;
  for (const char c : body) sum ^= static_cast<unsigned char>(c);
  constexpr const char* digits = "0123456789ABCDEF";
  return as_bytes("$" + body + "*" + digits[sum >> 4] + digits[sum & 15] + "\r\n");
}

TEST(Parts, OfATextAreOneValueWithOneSign) {
  const auto description = described(columns);
  const auto fix = sentence("PFIX,13,30.5,-49,30.0,123,06.6,W");
  const auto record = decoded(description, fix);
  EXPECT_DOUBLE_EQ(value_of(record, "time_s"), 13 * 3600 + 30.5 * 60);
  EXPECT_NEAR(value_of(record, "latitude_deg"), -49.5, 1e-12);
  EXPECT_NEAR(value_of(record, "longitude_deg"), -123.11, 1e-12);
  const auto near = sentence("PFIX,0,0,-0,30,0,6,E");
  EXPECT_NEAR(value_of(decoded(description, near), "latitude_deg"), -0.5, 1e-12);
}

TEST(Parts, AreMissedIfOneOfThemIs) {
  const auto description = described(columns);
  const auto fix = sentence("PFIX,13,,-49,30.0,123,06.6,W");
  const auto record = decoded(description, fix);
  EXPECT_TRUE(std::isnan(value_of(record, "time_s")));
  EXPECT_NEAR(value_of(record, "latitude_deg"), -49.5, 1e-12);
}

TEST(Parts, OfAnEmulatedTextAreWholeNumbersButTheLast) {
  const auto description = described(columns);
  Readings readings;
  readings.set(Target::time, 13 * 3600 + 30.5 * 60);
  readings.set(Target::latitude, -0.5 * degree);
  readings.set(Target::longitude, -123.11 * degree);
  Buffer bytes(256);
  bytes.resize(
      wire::described::encode(description->plan, description->plan.messages[0], readings, bytes));
  EXPECT_EQ(bytes, sentence("PFIX,13,30.500,-0,30.0000,123,6.6000,W"));
}

/// The stamp of ROS messages: seconds and nanoseconds. Below zero the second part still counts up.
const std::string stamp = R"(
[sensor]
title = "toy"
kind = "depth"
[protocol]
[[protocol.binary]]
name = "stamped"
sync = "A5"
length = 13
fields = [
  { at = 1, type = "i32", field = "time_s", unit = "s" },
  { at = 5, type = "u32", name = "nanoseconds", unit = "ns", adds_to = "time_s" },
  { at = 9, type = "f32", field = "depth_m", unit = "m" },
]
)";

TEST(Parts, OfAStampAreSecondsAndNanoseconds) {
  const auto description = described(stamp);
  // 1700000000 = 6553F100h, 250000000 = 0EE6B280h; -1 + .25 s is 0.75 s before 1970.
  const Buffer after{0xA5, 0x00, 0xF1, 0x53, 0x65, 0x80, 0xB2, 0xE6, 0x0E, 0, 0, 0x80, 0x3F};
  const Buffer before{0xA5, 0xFF, 0xFF, 0xFF, 0xFF, 0x80, 0xB2, 0xE6, 0x0E, 0, 0, 0x80, 0x3F};
  EXPECT_DOUBLE_EQ(value_of(decoded(description, after), "time_s"), 1700000000.25);
  EXPECT_DOUBLE_EQ(value_of(decoded(description, before), "time_s"), -0.75);
  for (const auto& [time_s, bytes] : {std::pair{1700000000.25, after}, {-0.75, before}}) {
    Readings readings;
    readings.set(Target::time, time_s);
    readings.set(Target::depth, 1);
    Buffer written(16);
    written.resize(wire::described::encode(description->plan, description->plan.messages[0],
                                           readings, written));
    EXPECT_EQ(written, bytes) << time_s;
  }
}

TEST(Parts, WithoutAWholeOrItsUnitAreRefused) {
  const auto with = [](std::string text, const std::string& old, const std::string& put) {
    text.replace(text.find(old), old.size(), put);
    return problems_of(text);
  };
  EXPECT_THAT(with(stamp, "adds_to = \"time_s\"", "adds_to = \"times\""),
              HasSubstr("/fields/1/adds_to: names a 'field' of this message"));
  EXPECT_THAT(with(stamp, "unit = \"ns\"", "unit = \"mm\""),
              HasSubstr("a part of time_s needs a unit of it, such as \"s\""));
  EXPECT_THAT(with(stamp, "unit = \"ns\"", "unit = \"ns\", scale = -1"),
              HasSubstr("have positive scales"));
}

}  // namespace parts_test
}  // namespace drydock::described::test
