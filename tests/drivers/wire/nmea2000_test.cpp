#include "drivers/wire/nmea2000/nmea2000.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/fields.hpp"
#include "tests/drivers/wire/can_fixture.hpp"

namespace drydock::wire::nmea2000 {
namespace nmea2000_test {

using test::frame;
using test::only;
using test::text_of;

TEST(Nmea2000, EncodesTheBytesOfRealAndPublishedFrames) {
  EXPECT_EQ(text_of(encode(WaterDepth{0x74, 0, 2.08, -0.001, std::nullopt})),
            "0DF50B74#00D0000000FFFFFF");
  EXPECT_EQ(text_of(encode(Rudder{0xCC, 252, 0, std::nullopt, std::nullopt})),
            "09F10DCC#FCF8FF7FFF7FFFFF");
  const double rpm_600 = 600 * 2 * std::numbers::pi / 60;
  EXPECT_EQ(text_of(encode(Engine{1, 0, rpm_600, 100000, 50})), "09F20001#006009E80332FFFF");
  EXPECT_EQ(text_of(encode(Temperature{0x40, 42, 1, 3, 300.15, 295.15})),
            "15FD0840#2A01033F754B73FF");
  EXPECT_EQ(text_of(encode(Pressure{7, 5, 0, Pressure::water, 101325.0})),
            "15FD0A07#05000102760F00FF");
}

TEST(Nmea2000, AMissingValueGoesOutAsNotAvailableAndOneTooBigAsOutOfRange) {
  EXPECT_EQ(text_of(encode(WaterDepth{1, {}, {}, {}, {}})), "0DF50B01#FFFFFFFFFFFF7FFF");
  EXPECT_EQ(text_of(encode(WaterDepth{1, 0, -1.0, 40.0, 9999.0})), "0DF50B01#00FEFFFFFFFE7FFE");
  EXPECT_EQ(text_of(encode(Rudder{1, {}, {}, 1e9, std::numeric_limits<double>::quiet_NaN()})),
            "09F10D01#FFFFFE7FFF7FFFFF");
}

TEST(Nmea2000, AnOffsetOfMinusOneMillimetreIsANumber) {
  const auto depth = only<WaterDepth, Nmea2000>({frame("0DF50B74#00D0000000FFFFFF")});
  ASSERT_TRUE(depth.offset_m);
  EXPECT_DOUBLE_EQ(*depth.offset_m, -0.001);
}

/// canboat's database has -pi to pi. Its pgn-below-range-min.in sends 8000h.
TEST(Nmea2000, AYawBelowHalfATurnIsNoValue) {
  EXPECT_FALSE((only<Attitude, Nmea2000>({frame("0DF11902#01008047854885FF")}).yaw_rad));
  EXPECT_EQ((only<Attitude, Nmea2000>({frame("0DF11902#01488547854885FF")}).yaw_rad), -3.1416);
}

/// The three highest values of a field are not numbers; the value below them is the largest number.
template <class Raw>
void expect_three_sentinels(const std::string& id, std::size_t offset, const std::string& key) {
  for (int below = 0; below <= 3; ++below) {
    CanFrame f = frame(id + "#0000000000000000");
    store_le<Raw>(f.data, offset, static_cast<Raw>(std::numeric_limits<Raw>::max() - below));
    const auto shown = test::to_json(test::decode_all<Nmea2000>({f}).at(0));
    EXPECT_EQ(shown[key].is_null(), below < 3) << key << " " << below;
  }
}

TEST(Nmea2000, EveryFieldKeepsItsThreeReservedValuesBack) {
  expect_three_sentinels<std::uint8_t>("0DF50B01", 0, "sequence");
  expect_three_sentinels<std::uint32_t>("0DF50B01", 1, "depth_m");
  expect_three_sentinels<std::int16_t>("0DF50B01", 5, "offset_m");
  expect_three_sentinels<std::uint8_t>("0DF50B01", 7, "maximum_range_m");
  expect_three_sentinels<std::uint8_t>("15FD0A01", 1, "instance");
  expect_three_sentinels<std::uint8_t>("15FD0A01", 2, "kind");
  expect_three_sentinels<std::int32_t>("15FD0A01", 3, "pressure_pa");
  expect_three_sentinels<std::uint16_t>("15FD0801", 3, "actual_k");
  expect_three_sentinels<std::uint16_t>("15FD0801", 5, "set_k");
  expect_three_sentinels<std::int16_t>("09F10D01", 2, "angle_order_rad");
  expect_three_sentinels<std::int16_t>("09F10D01", 4, "position_rad");
  expect_three_sentinels<std::uint16_t>("09F20001", 1, "speed_radps");
  expect_three_sentinels<std::uint16_t>("09F20001", 3, "boost_pressure_pa");
  expect_three_sentinels<std::int8_t>("09F20001", 5, "tilt_percent");
  expect_three_sentinels<std::uint16_t>("09F11201", 1, "heading_rad");
  expect_three_sentinels<std::int16_t>("09F11201", 3, "deviation_rad");
  expect_three_sentinels<std::int16_t>("09F11201", 5, "variation_rad");
  expect_three_sentinels<std::int32_t>("09F11301", 1, "rate_radps");
  expect_three_sentinels<std::int16_t>("0DF11401", 1, "heave_m");
  expect_three_sentinels<std::int16_t>("0DF11901", 1, "yaw_rad");
  expect_three_sentinels<std::int16_t>("0DF11901", 3, "pitch_rad");
  expect_three_sentinels<std::int16_t>("0DF11901", 5, "roll_rad");
  expect_three_sentinels<std::uint16_t>("19F11A01", 2, "date_days");
  expect_three_sentinels<std::int16_t>("19F11A01", 4, "variation_rad");
  expect_three_sentinels<std::uint16_t>("09F50301", 1, "water_mps");
  expect_three_sentinels<std::uint16_t>("09F50301", 3, "ground_mps");
  expect_three_sentinels<std::uint8_t>("09F50301", 5, "sensor");
  expect_three_sentinels<std::uint16_t>("09F80201", 2, "course_rad");
  expect_three_sentinels<std::uint16_t>("09F80201", 4, "speed_mps");
  expect_three_sentinels<std::int16_t>("19FA0301", 2, "horizontal_dop");
  expect_three_sentinels<std::int16_t>("19FA0301", 4, "vertical_dop");
  expect_three_sentinels<std::int16_t>("19FA0301", 6, "time_dop");
  expect_three_sentinels<std::uint16_t>("15FD0601", 1, "water_k");
  expect_three_sentinels<std::uint16_t>("15FD0601", 3, "air_k");
  expect_three_sentinels<std::uint16_t>("15FD0601", 5, "air_pressure_pa");
  expect_three_sentinels<std::uint16_t>("15FD0701", 2, "temperature_k");
  expect_three_sentinels<std::int16_t>("15FD0701", 4, "humidity_percent");
  expect_three_sentinels<std::uint16_t>("15FD0701", 6, "air_pressure_pa");
  expect_three_sentinels<std::uint16_t>("0DF01001", 2, "utc_ns");
  expect_three_sentinels<std::uint32_t>("0DF01001", 4, "utc_ns");
}

TEST(Nmea2000, AFrameThatEndsBeforeItsFirstValueIsCountedAsDamaged) {
  Nmea2000::Decoder decoder;
  EXPECT_FALSE(decoder.receive(frame("15FD0A07#05000102760F")));
  EXPECT_EQ(decoder.counters().bad_checksums, 1u);
  EXPECT_EQ(decoder.counters().bytes_skipped, 6u);
}

TEST(Nmea2000, AShortFrameIsReadAsFarAsItGoes) {
  const auto pressure = only<Pressure, Nmea2000>({frame("15FD0A07#05000102760F00")});
  EXPECT_EQ(pressure.pressure_pa, 101325.0);
  const auto heading = only<VesselHeading, Nmea2000>({frame("09F11205#114ADC")});
  EXPECT_DOUBLE_EQ(heading.heading_rad.value(), 5.6394);
  EXPECT_FALSE(heading.deviation_rad || heading.variation_rad || heading.reference);
}

std::string hex_of(Bytes data) {
  std::string text;
  for (const std::uint8_t byte : data) text += fmt::format("{:02X}", byte);
  return text;
}

/// What our encoder makes of a decoded message: a frame, or the content of a fast packet.
struct Encoded {
  template <LaidOut M>
  std::string operator()(const M& m) const {
    if constexpr (is_fast<M>) {
      std::array<std::uint8_t, M::bytes> data;
      encode_payload(m, std::span{data});
      return hex_of(data);
    } else {
      return text_of(encode(m));
    }
  }
  std::string operator()(const SatellitesInView& m) const {
    std::array<std::uint8_t, SatellitesInView::longest> data;
    const std::size_t size = encode(m, data);
    return hex_of(Bytes{data}.first(size));
  }
  template <class Managed>
  std::string operator()(const Managed&) const {
    return "of j1939";
  }
};

/// The bytes are those that Python packs in fixtures/nmea2000/make_navigation.py. Its frames with
/// other reserved bits, another priority or impossible values are not among them.
TEST(Nmea2000, EncodesTheNavigationMessagesToTheBytesThatPythonPacks) {
  std::vector<std::string> encoded;
  for (const auto& message :
       test::decode_all<Nmea2000>(test::frames_of_log(test::fixture("nmea2000/frames.log"))))
    encoded.push_back(std::visit(Encoded{}, message));
  for (const char* bytes :
       {"09F11205#11B77A85FFC801FC", "0DF11905#134985D204D7F6FF", "19F11A05#14F82B51F5FDFFFF",
        "09F50307#173801350104F1FF", "0DF01008#18F02B51FF977F33", "09F80108#00175BCA00D2496B",
        "09F80208#19FD6FF5FFFFFFFF", "15FD0609#1C9B6EE772F503FF", "15FD0709#1D41E7723930F503",
        "2B5115CD5B07671200000C000000", "44535FF5FD5C3D5D3DDD176903FA00D204D8FF5E3D",
        "1BFD02112816A3A0361085FFFFFFF247F4FFFFFFFF7FFFFFFF7F15"})
    EXPECT_THAT(encoded, ::testing::Contains(bytes));
}

TEST(Nmea2000, APositionFixIsEncodedToTheBytesThatPythonPacks) {
  GnssPosition fix{.source = 8,
                   .sequence = 25,
                   .utc_ns = 1795317945678900000,
                   .latitude_rad = radians(42.5),
                   .longitude_rad = radians(-71.25),
                   .altitude_m = 12.345678,
                   .system = 3,
                   .method = 1,
                   .satellites = 9,
                   .horizontal_dop = 1.1,
                   .position_dop = std::nullopt,
                   .geoid_height_m = -33.63,
                   .integrity = std::nullopt,
                   .reference_stations = std::nullopt,
                   .station_system = std::nullopt,
                   .station_id = std::nullopt,
                   .station_age_s = std::nullopt};
  std::array<std::uint8_t, GnssPosition::bytes> data;
  encode_payload(fix, std::span{data});
  EXPECT_EQ(hex_of(data),
            "192B5115CD5B0700808A8D3FE7E50500C0886506B11CF64E61BC000000000013"
            "FF096E00FF7FDDF2FFFFFF");
}

/// Layout of canboat's database: integrity in the low bits of byte 32, the number of stations in
/// byte 42, then of each the system, twelve bits of identifier and the age in .01 s.
TEST(Nmea2000, APositionFixSaysItsIntegrityAndItsReferenceStation) {
  std::array<std::uint8_t, 47> message{};
  message[31] = 0x23;  // GPS and GLONASS, DGNSS
  message[32] = 0xFD;
  message[42] = 1;
  message[43] = 0x21;  // system 1, identifier 582h
  message[44] = 0x58;
  message[45] = 0xC2;  // 4.5 s
  message[46] = 0x01;
  const auto fix = decode<GnssPosition>(8, message).value();
  EXPECT_EQ(fix.integrity, 1);
  EXPECT_EQ(fix.reference_stations, 1);
  EXPECT_EQ(fix.station_system, 1);
  EXPECT_EQ(fix.station_id, 0x582);
  EXPECT_NEAR(fix.station_age_s.value(), 4.5, 1e-12);
  message[42] = 0;
  const auto alone = decode<GnssPosition>(8, Bytes(message).first(43)).value();
  EXPECT_EQ(alone.reference_stations, 0);
  EXPECT_FALSE(alone.station_system || alone.station_id || alone.station_age_s);
}

TEST(Nmea2000, TheHighestValueOfTwoBitsAndTheTwoHighestOfFourBitsAreNoNumbers) {
  const auto reference = [](const char* text) {
    return only<VesselHeading, Nmea2000>({frame(text)}).reference;
  };
  EXPECT_EQ(reference("09F11201#00000000000000FE"), 2);
  EXPECT_EQ(reference("09F11201#00000000000000FF"), std::nullopt);
  const auto direction = [](const char* text) {
    return only<Speed, Nmea2000>({frame(text)}).direction;
  };
  EXPECT_EQ(direction("09F50301#000000000000FDFF"), 13);
  EXPECT_EQ(direction("09F50301#000000000000FEFF"), std::nullopt);
  EXPECT_EQ(direction("09F50301#000000000000FFFF"), std::nullopt);
}

/// 3 bytes, then 12 for each satellite.
std::vector<CanFrame> satellites_in_view(std::uint8_t claimed, std::size_t sent) {
  std::vector<std::uint8_t> message(3 + 12 * sent, 0x11);
  message[2] = claimed;
  std::vector<CanFrame> frames;
  for (std::size_t i = 0; i < fast_packet_frames(message.size()); ++i)
    frames.push_back(encode_fast_packet({6, 129540, 255, 8}, 1, message, i));
  return frames;
}

TEST(Nmea2000, TheSatelliteListEndsWhereTheMessageOrItsCountEnds) {
  EXPECT_EQ((only<SatellitesInView, Nmea2000>(satellites_in_view(18, 18)).satellites.size()), 18u);
  EXPECT_EQ((only<SatellitesInView, Nmea2000>(satellites_in_view(4, 3)).satellites.size()), 3u);
  EXPECT_EQ((only<SatellitesInView, Nmea2000>(satellites_in_view(2, 3)).satellites.size()), 2u);
  EXPECT_TRUE(test::decode_all<Nmea2000>(satellites_in_view(19, 18)).empty());
}

TEST(Nmea2000, TheLastSatelliteOfAMessageCutShortIsReadAsFarAsItGoes) {
  std::array<std::uint8_t, 12> message{1,    0xFD, 1,    17,   0x28, 0x16,
                                       0xA3, 0xA0, 0x36, 0x10, 0x85, 0xFF};
  const auto cut = decode_satellites_in_view(8, message).value();
  ASSERT_EQ(cut.satellites.size(), 1u);
  EXPECT_EQ(cut.satellites[0].number, 17);
  EXPECT_DOUBLE_EQ(cut.satellites[0].snr_db.value(), 41.5);
  EXPECT_FALSE(cut.satellites[0].residual_m || cut.satellites[0].status);
}

TEST(Nmea2000, ReadsDepthAsGpsdDoes) {
  const std::string log = test::corpus("n2k/gpsd/logfile_20140914_365495765_can.log");
  const auto frames = test::frames_of_log(log);
  if (frames.empty()) GTEST_SKIP() << "corpora absent: n2k";
  std::vector<double> expected;
  for (const auto& line : test::lines_of(log + ".chk")) {
    const auto object = nlohmann::json::parse(line, nullptr, false);
    if (object.is_object() && object.contains("depth")) expected.push_back(object["depth"]);
  }
  std::vector<WaterDepth> depths;
  for (const auto& message : test::decode_all<Nmea2000>(frames)) {
    if (const auto* depth = std::get_if<WaterDepth>(&message)) depths.push_back(*depth);
  }
  ASSERT_EQ(depths.size(), 198u);
  ASSERT_EQ(depths.size(), expected.size());
  for (std::size_t i = 0; i < depths.size(); ++i) {
    EXPECT_NEAR(depths[i].depth_m.value(), expected[i], 0.005);
  }
}

}  // namespace nmea2000_test
}  // namespace drydock::wire::nmea2000
