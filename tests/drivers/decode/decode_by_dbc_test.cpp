#include <gmock/gmock.h>

#include "tests/drivers/decode/captured.hpp"

namespace drydock::decode {
namespace decode_by_dbc_test {

using nlohmann::json;
using testing::HasSubstr;

const std::string folder = DRYDOCK_SOURCE_DIR "/fixtures/dbc/";

Decoded by_dbc(const std::string& file, const std::string& capture, bool count = false) {
  DecodeOptions options;
  options.dbc = file;
  options.file = capture;
  options.count = count;
  return run_decode(options);
}

TEST(DecodeByDbc, EachMessageIsALineWithItsSignals) {
  const Decoded decoded = by_dbc(folder + "bus.dbc", folder + "frames.log");
  EXPECT_EQ(decoded.exit_code, 0);
  const auto lines = decoded.lines();
  std::ifstream expected(folder + "frames.expected.jsonl");
  std::size_t compared = 0;
  for (std::string text; std::getline(expected, text); ++compared) {
    const json wanted = json::parse(text);
    ASSERT_LT(compared, lines.size());
    for (const auto& [key, value] : wanted.items()) {
      const json& ours = lines[compared].at(key);
      if (!value.is_number()) {
        EXPECT_EQ(ours, value) << text << key;
        continue;
      }
      ASSERT_TRUE(ours.is_number()) << text << key;
      EXPECT_NEAR(ours.get<double>(), value.get<double>(), 1e-9) << text << key;
    }
    const bool is_j1939 = wanted["type"] == "slope" || wanted["type"] == "serial";
    EXPECT_EQ(lines[compared].size(), wanted.size() + (is_j1939 ? 4 : 2)) << text;
  }
  EXPECT_EQ(compared, 8u);
  EXPECT_EQ(lines.size(), compared);
}

TEST(DecodeByDbc, EachKeyStandsOnceWhateverTheSignalsAreCalled) {
  const TemporaryFile capture("(1.0) can0 100#0102030405060708\n");
  const auto keys = [&](const std::string& signals) {
    const TemporaryFile dbc("VERSION \"\"\nBU_: A\nBO_ 256 M: 8 A\n" + signals);
    return by_dbc(dbc.path(), capture.path()).out;
  };
  const auto own = keys(
      " SG_ type : 0|8@1+ (1,0) [0|0] \"\" A\n SG_ time_s : 8|8@1+ (1,0) [0|0] \"\" A\n"
      " SG_ interface : 16|8@1+ (1,0) [0|0] \"\" A\n");
  EXPECT_EQ(own,
            "{\"type\":\"M\",\"time_s\":1,\"interface\":\"can0\",\"device_type\":1,"
            "\"device_time_s\":2,\"device_interface\":3}\n");
  const auto twice =
      keys(" SG_ S : 0|8@1+ (1,0) [0|0] \"\" A\n SG_ S : 8|8@1+ (2,0) [0|0] \"\" A\n");
  if (!twice.empty()) EXPECT_THAT(twice, HasSubstr("\"S\":1,\"S_2\":4"));
}

TEST(DecodeByDbc, WhatHasNoMessageIsCountedByItsIdentifier) {
  const Decoded decoded = by_dbc(folder + "bus.dbc", folder + "frames.log");
  EXPECT_EQ(decoded.err,
            "candump-log: 13 frames, 8 messages, 1 of them cut short, 3 frames without a message\n"
            "no message: 7FF (2) 0CF02AE2 (1)\n");
}

/// The sender is the lowest byte of the identifier; 255 is every node.
TEST(DecodeByDbc, AMessageOfJ1939SaysWhoSentItToWhom) {
  const auto lines = by_dbc(folder + "bus.dbc", folder + "frames.log").lines();
  ASSERT_EQ(lines.size(), 8u);
  EXPECT_EQ(lines[6].at("source"), 0xE2);
  EXPECT_EQ(lines[6].at("destination"), 255);
  EXPECT_EQ(lines[7].at("source"), 0x42) << "of the transport protocol";
  EXPECT_FALSE(lines[0].contains("source")) << "11 bits name no sender";
}

/// 2^53 + 1 is the first whole number that a double does not hold.
TEST(DecodeByDbc, IntegersAreExactToTheirLastDigit) {
  const TemporaryFile dbc(
      "BO_ 1 a: 8 n\n SG_ u : 0|64@1+ (1,0) [0|0] \"\" n\n"
      "BO_ 2 b: 8 n\n SG_ s : 7|64@0- (1,0) [0|0] \"\" n\n"
      "BO_ 3 c: 8 n\n SG_ scaled : 0|60@1+ (10,-3) [0|0] \"\" n\n"
      "BO_ 4 d: 8 n\n SG_ half : 0|64@1+ (0.5,0) [0|0] \"\" n\n");
  const TemporaryFile log(
      "(1.0) can0 001#0100000000002000\n(1.0) can0 001#FFFFFFFFFFFFFFFF\n"
      "(1.0) can0 002#8000000000000001\n(1.0) can0 002#FFFFFFFFFFFFFFFF\n"
      "(1.0) can0 003#0100000000002000\n(1.0) can0 004#0300000000000000\n");
  const auto lines = by_dbc(dbc.path(), log.path()).lines();
  ASSERT_EQ(lines.size(), 6u);
  EXPECT_EQ(lines[0].at("u").dump(), "9007199254740993");
  EXPECT_EQ(lines[1].at("u").dump(), "18446744073709551615");
  EXPECT_EQ(lines[2].at("s").dump(), "-9223372036854775807");
  EXPECT_EQ(lines[3].at("s").dump(), "-1");
  EXPECT_EQ(lines[4].at("scaled").dump(), "90071992547409927");  // 10 * (2^53 + 1) - 3
  EXPECT_EQ(lines[5].at("half").dump(), "1.5");
}

TEST(DecodeByDbc, ErrorAndRemoteFramesAreNotFramesWithoutAMessage) {
  const TemporaryFile dbc("BO_ 256 a: 1 n\n SG_ s : 0|8@1+ (1,0) [0|0] \"\" n\n");
  const TemporaryFile log(
      "(1.0) can0 100#05\n(1.1) can0 100#R\n(1.2) can0 20000004#0000000000000000\n");
  const Decoded decoded = by_dbc(dbc.path(), log.path());
  EXPECT_EQ(decoded.lines().size(), 1u);
  EXPECT_EQ(decoded.err,
            "candump-log: 3 frames, 1 messages, 0 of them cut short, 0 frames without a message\n"
            "1 error frames, 1 remote frames: they carry no signals\n");
}

TEST(DecodeByDbc, CountsMessagesByTheirName) {
  const Decoded decoded = by_dbc(folder + "bus.dbc", folder + "frames.log", true);
  const auto lines = decoded.lines();
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[1], (json{{"type", "status"}, {"count", 5}}));
}

TEST(DecodeByDbc, AnErrorInTheFileIsNamedWithLineAndColumn) {
  const TemporaryFile damaged("BO_ 1 a: 8 n\n SG_ s : 0|99@1+ (1,0) [0|0] \"\" n\n");
  const Decoded decoded = by_dbc(damaged.path(), folder + "frames.log");
  EXPECT_EQ(decoded.exit_code, 2);
  EXPECT_THAT(decoded.err, HasSubstr(":2:12: the number of bits is beyond 1 to 64\n"));
  EXPECT_EQ(decoded.out, "");
}

TEST(DecodeByDbc, AFileThatIsNotThereIsAnError) {
  const Decoded decoded = by_dbc("/nowhere.dbc", folder + "frames.log");
  EXPECT_EQ(decoded.exit_code, 2);
  EXPECT_THAT(decoded.err, HasSubstr("cannot read /nowhere.dbc"));
}

TEST(DecodeByDbc, NothingDecodedIsExitCodeOne) {
  const TemporaryFile other("BO_ 1 a: 8 n\n");
  EXPECT_EQ(by_dbc(other.path(), folder + "frames.log").exit_code, 1);
}

}  // namespace decode_by_dbc_test
}  // namespace drydock::decode
