#include "drivers/decode/decode.hpp"

#include <gmock/gmock.h>

#include <map>
#include <set>
#include <span>
#include <variant>

#include "drivers/wire/registry.hpp"
#include "tests/drivers/decode/captured.hpp"

namespace drydock::decode {
namespace decode_test {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

// The example for GGA on the gpsd project's page on NMEA sentences.
constexpr std::string_view gga =
    "$GPGGA,123519,4807.038,N,01131.324,E,1,08,0.9,545.4,M,46.9,M,,*42\r\n";

Decoded decode_text(const std::string& protocol, std::string_view bytes, bool count = false) {
  const TemporaryFile file(bytes);
  return run_decode({protocol, file.path(), count, false});
}

TEST(Decode, OneLinePerMessageWithUnitsInItsKeysAndNullForWhatIsNotThere) {
  const Decoded decoded = decode_text("nmea0183", gga);
  EXPECT_EQ(decoded.exit_code, 0);
  const auto lines = decoded.lines();
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0]["type"], "GGA");
  EXPECT_EQ(lines[0]["talker"], "GP");
  EXPECT_NEAR(lines[0]["latitude_deg"].get<double>(), 48.1173, 1e-9);
  EXPECT_NEAR(lines[0]["longitude_deg"].get<double>(), 11.5220666667, 1e-9);
  EXPECT_EQ(lines[0]["mean_sea_level_height_m"], 545.4);
  EXPECT_TRUE(lines[0]["differential_age_s"].is_null());
  EXPECT_EQ(decoded.err, "1 frames, 1 messages, 0 bad checksums, 0 bytes skipped\n");
}

TEST(Decode, NoiseIsSkippedAndCounted) {
  const Decoded decoded = decode_text("nmea0183", "noise\n" + std::string(gga) + "\xff\xff");
  EXPECT_EQ(decoded.lines().size(), 1u);
  EXPECT_EQ(decoded.err, "1 frames, 1 messages, 0 bad checksums, 8 bytes skipped\n");
}

TEST(Decode, TheLastLineMayLackItsEnd) {
  const Decoded decoded = decode_text("nmea0183", gga.substr(0, gga.size() - 2));
  EXPECT_EQ(decoded.lines().size(), 1u);
  EXPECT_THAT(decoded.err, HasSubstr(" 0 bytes skipped"));
}

TEST(Decode, AGoodFrameBehindAFalseSyncAtTheEndIsNotLost) {
  // A sync that claims 2048 bytes, then NAV-EOE of 10.000 s. The sum is over 01 61 04 00 10 27 00
  // 00.
  const std::string bytes(
      "\xB5\x62\x01\x07\x00\x08"
      "\xB5\x62\x01\x61\x04\x00\x10\x27\x00\x00\x9d\x7c",
      18);
  const Decoded decoded = decode_text("ubx", bytes);
  EXPECT_EQ(decoded.out, "{\"type\":\"NAV-EOE\",\"itow_s\":10}\n");
  EXPECT_EQ(decoded.err, "1 frames, 1 messages, 0 bad checksums, 6 bytes skipped\n");
}

TEST(Decode, ADamagedSentenceIsNoMessage) {
  std::string damaged(gga);
  damaged[10] ^= 1;
  const Decoded decoded = decode_text("nmea0183", damaged);
  EXPECT_EQ(decoded.exit_code, 1);
  EXPECT_EQ(decoded.out, "");
  EXPECT_THAT(decoded.err, HasSubstr("0 messages, 1 bad checksums"));
}

TEST(Decode, CanProtocolsReadCandumpAndKeepItsTimeAndInterface) {
  // NMEA 2000 water depth from canboat's candumpSample3: 2.08 m, offset -1 mm.
  const Decoded decoded =
      decode_text("nmea2000", "(1436509052.249713) can1 0DF50B74#00D0000000FFFFFF\n");
  const auto lines = decoded.lines();
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0]["type"], "water_depth");
  EXPECT_EQ(lines[0]["time_s"], 1436509052.249713);
  EXPECT_EQ(lines[0]["interface"], "can1");
  EXPECT_NEAR(lines[0]["depth_m"].get<double>(), 2.08, 1e-12);
  EXPECT_NEAR(lines[0]["offset_m"].get<double>(), -0.001, 1e-12);
  EXPECT_TRUE(lines[0]["maximum_range_m"].is_null());
}

TEST(Decode, CountingGivesOneLinePerType) {
  const Decoded decoded = decode_text("nmea0183", std::string(gga) + std::string(gga), true);
  EXPECT_EQ(decoded.out, "{\"type\":\"GGA\",\"count\":2}\n");
}

TEST(Decode, QuietSaysNothingBesideTheLines) {
  const TemporaryFile file(gga);
  EXPECT_EQ(run_decode({"nmea0183", file.path(), false, true}).err, "");
}

TEST(Decode, AnUnknownProtocolIsToldTheKnownOnes) {
  const Decoded decoded = decode_text("nmea", gga);
  EXPECT_EQ(decoded.exit_code, 2);
  EXPECT_EQ(decoded.err,
            "decode: unknown protocol \"nmea\", allowed: " + decode_protocols() + "\n");
  EXPECT_THAT(decode_protocols(), HasSubstr("ubx, nmea0183"));
}

TEST(Decode, AFileThatCannotBeReadIsSaidAndExitsWithOne) {
  const Decoded decoded = run_decode({"ubx", "/nowhere.log", false, false});
  EXPECT_EQ(decoded.exit_code, 1);
  EXPECT_EQ(decoded.err, "decode: cannot read /nowhere.log: No such file or directory\n");
  EXPECT_EQ(run_decode({"ubx", "/tmp", false, false}).exit_code, 1);
}

TEST(Decode, AnOutputThatCannotBeWrittenExitsWithOne) {
  const TemporaryFile file(gga);
  std::FILE* full = std::fopen("/dev/full", "w");
  ASSERT_NE(full, nullptr);
  MemoryFile err;
  EXPECT_EQ(decode({"nmea0183", file.path(), false, false}, full, err.file()), 1);
  std::fclose(full);
}

/// The keys of each message of a protocol, from its visit_fields.
class KeyTable {
 public:
  template <class... P>
  void add(wire::ProtocolList<P...>) {
    (add_variant(static_cast<typename P::Message*>(nullptr)), ...);
  }
  std::map<std::string, std::set<std::string>> keys;  ///< by type

 private:
  template <class... M>
  void add_variant(std::variant<M...>*) {
    (add_fields(std::string(M{}.type), M{}), ...);
  }
  template <class M>
  void add_fields(const std::string& type, const M& message) {
    visit_fields(message, [&](std::string_view key, const auto& value) {
      keys[type].emplace(key);
      add_items(type, value);
    });
  }
  template <class T>
  void add_items(const std::string&, const T&) {}
  template <class T>
  requires requires(const T& item) {
    visit_fields(item, [](auto, const auto&) {});
  }
  void add_items(const std::string& type, std::span<T>) {
    add_fields(type, std::remove_const_t<T>{});
  }
};

TEST(DecodeManual, ASectionForEachMessageHasJustItsKeys) {
  KeyTable table;
  table.add(wire::BytesProtocols{});
  table.add(wire::FrameProtocols{});
  table.add(wire::FramesAsTheyAre{});
  table.add(wire::FrameCarriers{});
  const std::string manual = read_file(DRYDOCK_SOURCE_DIR "/docs/sensors/decode.md");
  for (const auto& [type, keys] : table.keys) {
    const auto begin = manual.find("\n### " + type + "\n");
    ASSERT_NE(begin, std::string::npos) << "docs/sensors/decode.md has no section ### " << type;
    const std::string section = manual.substr(begin, manual.find("\n##", begin + 4) - begin);
    for (const std::string& key : keys) EXPECT_THAT(section, HasSubstr("`" + key + "`")) << type;
  }
}

}  // namespace decode_test
}  // namespace drydock::decode
