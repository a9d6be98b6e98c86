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
    EXPECT_EQ(lines[compared].size(), wanted.size() + 2) << text;  // time_s and interface
  }
  EXPECT_EQ(compared, 8u);
  EXPECT_EQ(lines.size(), compared);
}

TEST(DecodeByDbc, WhatHasNoMessageIsCountedByItsIdentifier) {
  const Decoded decoded = by_dbc(folder + "bus.dbc", folder + "frames.log");
  EXPECT_EQ(decoded.err,
            "candump-log: 13 frames, 8 messages, 1 of them cut short, 3 frames without a message\n"
            "no message: 7FF (2) 0CF02AE2 (1)\n");
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
