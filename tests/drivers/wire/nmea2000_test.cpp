#include "drivers/wire/nmea2000/nmea2000.hpp"

#include <gtest/gtest.h>

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
}

TEST(Nmea2000, AFrameShorterThanItsMessageIsCountedAsDamaged) {
  Nmea2000::Decoder decoder;
  EXPECT_FALSE(decoder.receive(frame("15FD0A07#05000102760F00")));
  EXPECT_EQ(decoder.counters().bad_checksums, 1u);
  EXPECT_EQ(decoder.counters().bytes_skipped, 7u);
}

std::optional<double> number(const nlohmann::json& fields, const char* key) {
  if (!fields.contains(key)) return std::nullopt;
  const auto& value = fields[key];
  return (value.is_object() ? value["value"] : value).template get<double>();
}

/// Both absent, or both numbers that differ by less than half a step.
void expect_same(const std::optional<double>& ours, const std::optional<double>& theirs,
                 double step, const nlohmann::json& context) {
  ASSERT_EQ(ours.has_value(), theirs.has_value()) << context;
  if (ours) {
    EXPECT_NEAR(*ours, *theirs, step / 2) << context;
  }
}

struct AgreesWithCanboat {
  const nlohmann::json& fields;

  void operator()(const WaterDepth& m) const {
    expect_same(m.depth_m, number(fields, "Depth"), 0.01, fields);
    expect_same(m.offset_m, number(fields, "Offset"), 0.001, fields);
    expect_same(m.maximum_range_m, number(fields, "Range"), 10, fields);
  }
  void operator()(const Rudder& m) const {
    expect_same(m.instance, number(fields, "Instance"), 1, fields);
    expect_same(m.direction_order, number(fields, "Direction Order"), 1, fields);
    expect_same(m.angle_order_rad, number(fields, "Angle Order"), 1e-4, fields);
    expect_same(m.position_rad, number(fields, "Position"), 1e-4, fields);
  }
  void operator()(const GnssPosition& m) const {
    expect_same(m.sequence, number(fields, "SID"), 1, fields);
    expect_same(m.method, number(fields, "Method"), 1, fields);
    expect_same(m.satellites, number(fields, "Number of SVs"), 1, fields);
    expect_same(m.geoid_height_m, number(fields, "Geoidal Separation"), 0.01, fields);
    if (m.utc_ns) {
      const double seconds = *number(fields, "Date") * 86400 + *number(fields, "Time") * 1e-4;
      EXPECT_NEAR(static_cast<double>(*m.utc_ns) * 1e-9, seconds, 1e-5);
    }
    if (m.method == 0) {  // canboat prints the values of a receiver without a fix; Drydock does not
      EXPECT_FALSE(m.latitude_rad || m.longitude_rad || m.altitude_m);
      return;
    }
    expect_same(degrees(m.latitude_rad), number(fields, "Latitude"), 1e-7, fields);
    expect_same(degrees(m.longitude_rad), number(fields, "Longitude"), 1e-7, fields);
    expect_same(m.altitude_m, number(fields, "Altitude"), 1e-5, fields);
    expect_same(m.horizontal_dop, number(fields, "HDOP"), 0.01, fields);
    expect_same(m.position_dop, number(fields, "PDOP"), 0.01, fields);
  }
  void operator()(const j1939::AddressClaimed& m) const {
    const auto name = j1939::to_name(m.name);
    EXPECT_EQ(name.identity_number, *number(fields, "Unique Number"));
    EXPECT_EQ(name.manufacturer_code, *number(fields, "Manufacturer Code"));
    EXPECT_EQ(name.function, *number(fields, "Device Function"));
    EXPECT_EQ(name.vehicle_system, *number(fields, "Device Class"));
    EXPECT_EQ(name.industry_group, *number(fields, "Industry Group"));
    EXPECT_EQ(name.arbitrary_address_capable, *number(fields, "Arbitrary address capable") == 1);
  }
  void operator()(const j1939::Request& m) const { EXPECT_EQ(m.pgn, *number(fields, "PGN")); }
  template <class Other>
  void operator()(const Other&) const {
    ADD_FAILURE() << "canboat saw no such message: " << fields;
  }
};

/// Reads `<0x18eeff01> [8] 05 a0 ...` of old candumps, otherwise a line of `candump -l`.
std::vector<CanFrame> canboat_sample(const std::string& path) {
  std::vector<CanFrame> frames;
  for (std::string line : test::lines_of(path)) {
    if (line.starts_with("<0x") && line.size() > 17) {
      std::string data = line.substr(17);
      std::erase(data, ' ');
      std::erase(data, '\r');
      line = "(0.0) can0 " + line.substr(3, 8) + "#" + data;
    }
    if (const auto parsed = candump::parse_line(line)) frames.push_back(parsed->frame);
  }
  return frames;
}

/// Compares our messages, in order, with canboat's for the same bus. Returns their number.
std::size_t compare_with_canboat(const std::string& sample) {
  const std::string folder = test::corpus("n2k/canboat/");
  const auto messages =
      test::decode_all<Nmea2000>(canboat_sample(folder + "samples/" + sample + ".txt"));
  constexpr std::array<int, 8> ours{127245, 127488, 128267, 129029, 130312, 130314, 59904, 60928};
  std::vector<nlohmann::json> expected;
  for (const auto& line : test::lines_of(folder + "expected/" + sample + ".txt.json")) {
    const auto object = nlohmann::json::parse(line, nullptr, false);
    if (!object.contains("pgn")) continue;
    if (std::find(ours.begin(), ours.end(), object["pgn"]) != ours.end())
      expected.push_back(object);
  }
  EXPECT_EQ(messages.size(), expected.size());
  for (std::size_t i = 0; i < std::min(messages.size(), expected.size()); ++i) {
    std::visit([&](const auto& m) { EXPECT_EQ(m.source, expected[i]["src"]); }, messages[i]);
    std::visit(AgreesWithCanboat{expected[i]["fields"]}, messages[i]);
  }
  return messages.size();
}

TEST(Nmea2000, ReadsARealBusAsCanboatDoes) {
  if (!std::filesystem::exists(test::corpus("n2k/canboat"))) GTEST_SKIP() << "corpora absent: n2k";
  EXPECT_GT(compare_with_canboat("candumpSample1"), 200u);
  EXPECT_GT(compare_with_canboat("candumpSample3"), 500u);
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
