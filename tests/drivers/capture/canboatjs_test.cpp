#include <gtest/gtest.h>

#include <array>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/can/gateway_line.hpp"
#include "drivers/wire/j1939/j1939.hpp"
#include "tests/drivers/capture/captures.hpp"
#include "tests/npm/node.hpp"

/// Lines of NMEA 2000 gateways, as canboatjs reads them, which signalk-server has inside.
namespace drydock::capture::testing {
namespace canboatjs_test {

TEST(LinesOfGateways, CanboatjsReadsTheSameMessages) {
  DRYDOCK_NEEDS_NODE();
  for (const std::string file :
       {"capture/actisense.txt", "capture/ydwg.txt", "capture/ikonvert.txt"}) {
    const Buffer bytes = wire::testing::fixture(file);
    const auto theirs = drydock::test::run_node("tests/npm/read_nmea2000_lines.cjs", {},
                                                std::string(bytes.begin(), bytes.end()));
    ASSERT_TRUE(theirs.is_object()) << file;
    const auto ours = read_capture(bytes).records;
    EXPECT_EQ(theirs["refused"], 0) << file;
    ASSERT_EQ(theirs["messages"].size(), ours.size()) << file;
    for (std::size_t i = 0; i < ours.size(); ++i) {
      const auto id = wire::j1939::parse_identifier(ours[i].frame.id);
      EXPECT_EQ(theirs["messages"][i]["pgn"], id.pgn) << file;
      EXPECT_EQ(theirs["messages"][i]["src"], id.source) << file;
    }
    const double latitude_deg =
        wire::load_le<std::int32_t>(ours.back().frame.payload(), 0) * 1e-7;  // PGN 129025
    EXPECT_NEAR(theirs["messages"].back()["fields"]["latitude"], latitude_deg, 1e-9) << file;
  }
}

/// PGN 129025 of 49.2749832 N, 123.1852 W, from address 7Fh.
TEST(LinesOfGateways, CanboatjsReadsWhatAnEmulatedOneSays) {
  DRYDOCK_NEEDS_NODE();
  wire::CanFrame position{.id = 0x09F8017F, .extended = true, .size = 8};
  wire::store_le<std::int32_t>(position.data, 0, 492'749'832);
  wire::store_le<std::int32_t>(position.data, 4, -1'231'852'000);
  std::array<std::uint8_t, wire::gateway_line::longest> line;
  const std::size_t size =
      wire::gateway_line::encode(position, std::chrono::hours(17) + std::chrono::milliseconds(7),
                                 wire::gateway_line::Way::received, line);
  const auto theirs = drydock::test::run_node(
      "tests/npm/read_nmea2000_lines.cjs", {},
      std::string(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(size)));
  ASSERT_EQ(theirs["messages"].size(), 1U) << theirs;
  EXPECT_EQ(theirs["messages"][0]["pgn"], 129025);
  EXPECT_EQ(theirs["messages"][0]["src"], 0x7F);
  EXPECT_NEAR(theirs["messages"][0]["fields"]["latitude"], 49.2749832, 1e-9);
  EXPECT_NEAR(theirs["messages"][0]["fields"]["longitude"], -123.1852, 1e-9);
}

}  // namespace canboatjs_test
}  // namespace drydock::capture::testing
