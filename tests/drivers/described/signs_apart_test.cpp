#include <gmock/gmock.h>

#include "drivers/wire/text_fields.hpp"
#include "tests/drivers/described/decoded.hpp"

/// Positions as NMEA 0183 writes them: degrees and minutes, and the hemisphere in a field of its
/// own.
namespace drydock::described::test {
namespace signs_apart_test {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using wire::described::Readings;
using wire::described::Record;
using wire::described::Target;
using wire::testing::as_bytes;

constexpr const char* geographic = R"(
[sensor]
title = "GLL by a description"
kind = "gnss"
[protocol]
[[protocol.sentences]]
id = "$GPGLL"
fields = [
  { field = "latitude_deg", unit = "ddmm", decimals = 2, width = 7 },
  { sign_of = "latitude_deg", plus = "N", minus = "S" },
  { field = "longitude_deg", unit = "ddmm", decimals = 2, width = 8 },
  { sign_of = "longitude_deg", plus = "E", minus = "W" },
]
)";

/// The example of the standard, as many pages show it: 49 degrees 16.45 minutes north, 123 degrees
/// 11.12 minutes west.
TEST(SignsApart, GiveTheHemisphereOfAPosition) {
  const auto description = described(geographic);
  const Record record = decoded(description, as_bytes("$GPGLL,4916.45,N,12311.12,W*71\r\n"));
  EXPECT_NEAR(value_of(record, "latitude_deg"), 49 + 16.45 / 60, 1e-12);
  EXPECT_NEAR(value_of(record, "longitude_deg"), -123 - 11.12 / 60, 1e-12);
}

TEST(SignsApart, WithoutThemThereIsNoValue) {
  const auto description = described(geographic);
  const Record record = decoded(description, as_bytes("$GPGLL,4916.45,,12311.12,X*30\r\n"));
  EXPECT_TRUE(std::isnan(value_of(record, "latitude_deg")));
  EXPECT_TRUE(std::isnan(value_of(record, "longitude_deg")));
}

TEST(SignsApart, AnEmulatedDeviceWritesThemAndNeverSixtyMinutes) {
  const auto description = described(geographic);
  const auto written = [&](double latitude_deg, double longitude_deg) {
    Readings readings;
    readings.set(Target::latitude, latitude_deg * M_PI / 180);
    readings.set(Target::longitude, longitude_deg * M_PI / 180);
    std::array<std::uint8_t, 128> out{};
    const auto& plan = description->plan;
    const std::size_t size = wire::described::encode(plan, plan.messages[0], readings, out);
    return std::string(wire::as_text(wire::Bytes(out).first(size)));
  };
  EXPECT_THAT(written(49 + 16.45 / 60, -123 - 11.12 / 60),
              StartsWith("$GPGLL,4916.45,N,12311.12,W*71"));
  EXPECT_THAT(written(-41.99999, 0.5), StartsWith("$GPGLL,4200.00,S,00030.00,E*"));
}

TEST(SignsApart, BelongToAFieldOfTheMessage) {
  std::string text = geographic;
  text.replace(text.find("sign_of = \"latitude_deg\""), 24, "sign_of = \"latitud\"");
  EXPECT_THAT(problems_of(text), HasSubstr("names a field of this message that has the sign"));
}

}  // namespace signs_apart_test
}  // namespace drydock::described::test
