#include "drivers/wire/dvl/water_linked_json.hpp"

#include <gtest/gtest.h>

#include "drivers/wire/dvl/json_reader.hpp"
#include "tests/drivers/wire/byte_streams.hpp"

namespace drydock::wire::testing {
namespace water_linked_json_test {

using namespace std::chrono_literals;
namespace wlj = water_linked_json;

constexpr double degree = 3.141592653589793 / 180;

/// The lines of fixtures/water-linked-json/make_golden.py. Texts point into the stream, so the test
/// decodes it in place.
template <class M>
M golden(std::size_t index = 0) {
  static const Buffer stream = fixture("water-linked-json/golden.jsonl");
  std::vector<M> found;
  Framer<WaterLinkedJson::max_frame> framer;
  framer.feed(stream, WaterLinkedJson::scan, [&](Bytes frame, std::size_t) {
    const auto message = WaterLinkedJson::decode(frame);
    if (const M* m = message ? std::get_if<M>(&*message) : nullptr) found.push_back(*m);
  });
  return found.at(index);
}

TEST(WaterLinkedJson, VelocityForwardStarboardDownWithItsOwnTimes) {
  const auto m = golden<wlj::Velocity>();
  EXPECT_TRUE(m.valid);
  EXPECT_EQ(m.velocity_mps, (water_linked::Velocity{0.5, -0.1, 0.02}));
  EXPECT_EQ(m.altitude_m, 10.0);
  EXPECT_EQ(m.figure_of_merit_mps, 0.003464);
  EXPECT_EQ(m.covariance[0], 1e-5);
  EXPECT_EQ(m.covariance[4], 1.2e-5);
  EXPECT_EQ(m.covariance[8], 2e-6);
  EXPECT_EQ(m.covariance[5], 0);
  EXPECT_EQ(m.validity, 1700000000000000us);
  EXPECT_EQ(*m.transmission - *m.validity, 80ms);
  EXPECT_DOUBLE_EQ(*m.interval_s, 0.1253);
  EXPECT_FALSE(m.hot);
  EXPECT_EQ(m.format, "json_v3.3");
}

TEST(WaterLinkedJson, EachTransducerWithTheVelocityTowardTheBed) {
  const auto m = golden<wlj::Velocity>();
  // d . v with the beams 22.5 degrees from the vertical at +135, -135, -45 and +45 degrees.
  const std::array expected{-0.143881, -0.089762, 0.180836, 0.126717};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(m.transducers[i].id, static_cast<int>(i));
    EXPECT_TRUE(m.transducers[i].valid);
    EXPECT_NEAR(*m.transducers[i].velocity_mps, expected[i], 1e-6);
    EXPECT_EQ(m.transducers[i].distance_m, 10.824);
    EXPECT_EQ(m.transducers[i].rssi_dbm, -30.1);
    EXPECT_EQ(m.transducers[i].noise_dbm, -95.2);
  }
}

TEST(WaterLinkedJson, WithoutLockZerosAndMinusOneAreNoValues) {
  const auto m = golden<wlj::Velocity>(1);
  EXPECT_FALSE(m.valid);
  EXPECT_EQ(m.velocity_mps, water_linked::Velocity{});
  EXPECT_FALSE(m.altitude_m);
  EXPECT_TRUE(m.hot);
  EXPECT_FALSE(m.transducers[3].velocity_mps || m.transducers[3].distance_m);
  EXPECT_EQ(m.transducers[3].noise_dbm, -95.2) << "measured without an echo too";
}

TEST(WaterLinkedJson, OneLostBeamLeavesAVelocity) {
  const auto m = golden<wlj::Velocity>(2);
  EXPECT_EQ(m.velocity_mps, (water_linked::Velocity{-1.25, 0.375, 0.0625}));
  EXPECT_FALSE(m.transducers[2].valid || m.transducers[2].distance_m);
  EXPECT_EQ(m.transducers[1].distance_m, 3.788);
  EXPECT_EQ(m.covariance[2], -2e-6);
  EXPECT_EQ(m.covariance[7], 3e-7);
}

TEST(WaterLinkedJson, TheFirstFirmwareNamesNoTypeAndNoTimes) {
  const auto m = golden<wlj::Velocity>(3);
  EXPECT_EQ(m.format, "json_v1");
  EXPECT_EQ(m.velocity_mps, (water_linked::Velocity{1.5, 0.25, -0.125}));
  EXPECT_EQ(m.altitude_m, 7.25);
  EXPECT_FALSE(m.validity || m.transmission || m.covariance[0]);
  EXPECT_EQ(m.transducers[0].rssi_dbm, 30.1) << "as sent";
  EXPECT_EQ(golden<wlj::Velocity>(4).velocity_mps, water_linked::Velocity{});
  EXPECT_EQ(golden<wlj::Velocity>(5).format, "json_v2");
}

TEST(WaterLinkedJson, NotANumberIsNoValue) {
  const auto m = golden<wlj::Velocity>(6);
  EXPECT_TRUE(m.valid) << "as sent";
  EXPECT_EQ(m.velocity_mps, (water_linked::Velocity{std::nullopt, 0.1, std::nullopt}));
  EXPECT_FALSE(m.figure_of_merit_mps || m.covariance[4]);
  EXPECT_EQ(m.validity, 1700000000300000us);
}

TEST(WaterLinkedJson, AnUnknownVersionIsReadByItsKeys) {
  const auto m = golden<wlj::Velocity>(7);
  EXPECT_EQ(m.format, "json_v4");
  EXPECT_EQ(m.velocity_mps[0], 0.5);
}

TEST(WaterLinkedJson, WaterTrackHasNoAltitude) {
  const auto m = golden<wlj::WaterVelocity>();
  EXPECT_EQ(m.velocity_mps, (water_linked::Velocity{0.75, 0.125, -0.25}));
  EXPECT_FALSE(m.altitude_m);
  EXPECT_EQ(m.validity, 1700000000400000us);
}

TEST(WaterLinkedJson, DeadReckoningSinceTheLastReset) {
  const auto m = golden<wlj::Position>();
  EXPECT_EQ(m.time_s, 49056.809);
  EXPECT_EQ(m.position_m[0], 12.43563);
  EXPECT_EQ(m.position_m[2], 1.76764);
  EXPECT_EQ(m.position_deviation_m, 0.001959);
  EXPECT_NEAR(*m.roll_rad, 0.5 * degree, 1e-12);
  EXPECT_NEAR(*m.pitch_rad, -1.25 * degree, 1e-12);
  EXPECT_NEAR(*m.yaw_rad, 64.84 * degree, 1e-12);
  EXPECT_FALSE(m.trouble);
  const auto bad = golden<wlj::Position>(1);
  EXPECT_TRUE(bad.trouble);
  EXPECT_FALSE(bad.position_m[0] || bad.position_deviation_m) << "null";
}

TEST(WaterLinkedJson, AnAnswerNamesItsCommandAndItsError) {
  const auto read = golden<wlj::Response>();
  EXPECT_EQ(read.response_to, "get_config");
  EXPECT_TRUE(read.success);
  const auto settings = wlj::read_configuration(read.result).value();
  EXPECT_EQ(settings.sound_speed_mps, 1490.5);
  EXPECT_NEAR(*settings.mounting_rotation_rad, 20.25 * degree, 1e-12);
  EXPECT_EQ(settings.acoustic_enabled, true);
  EXPECT_EQ(settings.dark_mode, false);
  EXPECT_EQ(settings.range_mode, "1<=3");
  EXPECT_EQ(settings.periodic_cycling, true);
  const auto refused = golden<wlj::Response>(1);
  EXPECT_FALSE(refused.success);
  EXPECT_EQ(refused.error_message, R"(No key \"mountig_rotation_offset\" {)") << "as written";
  EXPECT_FALSE(wlj::read_configuration(refused.result)) << "null";
}

TEST(WaterLinkedJson, AnAnswerWithoutALineEndEndsWhereTheNextObjectBegins) {
  const auto old = golden<wlj::Response>(2);
  EXPECT_EQ(wlj::read_configuration(old.result)->dark_mode, true) << "its name in json_v3";
  EXPECT_EQ(golden<wlj::Velocity>(8).velocity_mps[0], 0.5) << "on the same line";
}

TEST(WaterLinkedJson, CommandsWithAndWithoutParameters) {
  EXPECT_EQ(golden<wlj::Command>().command, "set_config");
  EXPECT_EQ(wlj::read_configuration(golden<wlj::Command>().parameters)->sound_speed_mps, 1480.0);
  EXPECT_EQ(golden<wlj::Command>(1).command, "reset_dead_reckoning");
  EXPECT_EQ(golden<wlj::Command>(1).parameters, "");
  EXPECT_EQ(golden<wlj::Command>(2).command, "get_config") << "with blanks";
}

TEST(WaterLinkedJson, AnUnknownTypeIsToldByItsName) {
  EXPECT_EQ(golden<wlj::Other>().name, "temperature");
  EXPECT_EQ(golden<wlj::Other>().format, "json_v4");
}

std::optional<WaterLinkedJson::Message> read(std::string_view line) {
  const Buffer bytes = as_bytes(line);
  return WaterLinkedJson::decode(bytes);
}

wlj::Velocity velocity_of(std::string_view line) {
  return std::get<wlj::Velocity>(read(line).value());
}

TEST(WaterLinkedJson, ValuesOfAnotherKindAreNone) {
  const auto m = velocity_of(R"({"vx":"1","vy":{"a":1},"vz":[1],"altitude":true,"fom":1e999,)"
                             R"("covariance":[[1,2],[3]],"transducers":7,"velocity_valid":true})");
  EXPECT_EQ(m.velocity_mps, water_linked::Velocity{});
  EXPECT_FALSE(m.altitude_m || m.figure_of_merit_mps || m.covariance[0]);
  EXPECT_FALSE(velocity_of(R"({"vx":1,"velocity_valid":"yes"})").velocity_mps[0]);
}

TEST(WaterLinkedJson, AFifthTransducerIsPassedOver) {
  const auto m = velocity_of(R"({"transducers":[{"id":0},{"id":1},{"id":2},{"id":3},{"id":4}],)"
                             R"("velocity_valid":true})");
  EXPECT_EQ(m.transducers[3].id, 3);
}

Scan scan(std::string_view text) { return WaterLinkedJson::scan(as_bytes(text)); }

TEST(WaterLinkedJson, AnObjectInsideATornLineIsNoFrame) {
  EXPECT_EQ(scan("{\"id\":0},{\"id\":1}]"), Scan::skip(1));
  EXPECT_EQ(scan("{\"id\":0}\r\n"), Scan::frame(10));
}

TEST(WaterLinkedJson, BrokenGrammarIsADamagedLine) {
  for (const char* broken :
       {"{\"a\"1}\n", "{\"a\":}\n", "{\"a\":1,}\n", "{\"a\":1\r\n", "{\"a\":01x}\n",
        "{\"a\":tru}\n", "{\"a\":\"\\q\"}\n", "{\"a\":\"\\u00g0\"}\n", "{\"a\":\"\t\"}\n",
        "{\"a\":-}\n", "{\"a\":1.}\n", "{\"a\":[1}\n", "{\"a\":\"\n", "{\"\":[[[[[[[[1]]]]]]]]}\n"})
    EXPECT_EQ(scan(broken), Scan::bad_checksum()) << broken;
  EXPECT_EQ(scan("{\"\":[[[[[[[1]]]]]]]}\n"), Scan::frame(21)) << "eight deep";
}

TEST(WaterLinkedJson, ALineWithoutAnEndDoesNotHoldTheStream) {
  const std::string endless = "{\"a\":\"" + std::string(WaterLinkedJson::max_frame, 'x');
  EXPECT_EQ(scan(endless), Scan::bad_checksum());
  EXPECT_EQ(scan(endless.substr(0, 1000)), Scan::need_more());
}

TEST(WaterLinkedJson, TheEncoderWritesTheMadeLine) {
  const Buffer stream = fixture("water-linked-json/golden.jsonl");
  const std::string_view line = as_text(stream).substr(0, as_text(stream).find('\n') + 1);
  std::array<std::uint8_t, WaterLinkedJson::max_frame> bytes;
  const std::size_t size = encode(golden<wlj::Velocity>(), bytes);
  // Python writes 0.0 for a double without a fraction, the DVL and this encoder 0.
  std::string expected(line);
  expected.replace(expected.find("\"altitude\":10.0"), 15, "\"altitude\":10");
  EXPECT_EQ(as_text({bytes.data(), size}), expected);
  EXPECT_EQ(encode(golden<wlj::Velocity>(), std::span(bytes).first(size - 1)), 0u);
}

TEST(WaterLinkedJson, TheEncoderWritesAnswersAndCommands) {
  std::array<std::uint8_t, 512> bytes;
  const auto written = [&](const auto& m) {
    return std::string(as_text(Bytes{bytes}.first(encode(m, bytes))));
  };
  EXPECT_EQ(written(wlj::Response{"trigger_ping", false, "Queue full", {}, "json_v3.3"}),
            R"({"response_to":"trigger_ping","success":false,"error_message":"Queue full",)"
            R"("result":null,"format":"json_v3.3","type":"response"})"
            "\r\n");
  EXPECT_EQ(written(wlj::Command{"set_config", R"({"range_mode":"=2"})"}),
            "{\"command\":\"set_config\",\"parameters\":{\"range_mode\":\"=2\"}}\r\n");
  EXPECT_EQ(written(wlj::Command{"get_config", {}}), "{\"command\":\"get_config\"}\r\n");
  wlj::Configuration settings;
  settings.sound_speed_mps = 1490.5;
  settings.mounting_rotation_rad = 20 * degree;
  settings.acoustic_enabled = false;
  const std::size_t size = wlj::encode_configuration(settings, bytes);
  EXPECT_EQ(as_text(Bytes{bytes}.first(size)),
            R"({"speed_of_sound":1490.5,"acoustic_enabled":false,"mounting_rotation_offset":20})");
}

}  // namespace water_linked_json_test
}  // namespace drydock::wire::testing
