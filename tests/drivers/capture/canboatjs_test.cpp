#include <gtest/gtest.h>

#include "drivers/wire/bytes.hpp"
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

}  // namespace canboatjs_test
}  // namespace drydock::capture::testing
