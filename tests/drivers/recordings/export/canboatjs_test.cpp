#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drivers/recordings/export/exporter.hpp"
#include "tests/drivers/recordings/sample_dive/sample_dive.hpp"
#include "tests/npm/node.hpp"

/// The candump log of a recording, read by canboatjs, which signalk-server has inside.
namespace drydock::exporting {
namespace canboatjs_test {

using nlohmann::json;

class Canboatjs : public testing::Test {
 protected:
  void SetUp() override { DRYDOCK_NEEDS_NODE(); }

  json reads(bool direction) {
    const std::string log = folder_ / (direction ? "both.log" : "plain.log");
    const auto done =
        export_recording(dive_, {}, Format::candump,
                         {.path = log, .overwrite = false, .plain = false, .direction = direction},
                         [](double) { return true; });
    EXPECT_TRUE(done);
    return test::run_node("tests/npm/read_nmea2000_lines.cjs", {}, record::test::read_all(log));
  }

  record::test::TestFolder folder_;
  std::string dive_ = folder_ / "dive.mcap";
  record::test::SampleCounts counts_ = record::test::write_sample_dive(dive_);
};

// fixtures/nmea2000/NOTE.md: canboat's analyzer reads 2.08 m out of the first frame, and 600 rpm
// stands in the sixth. The position is that of the sample dive.
TEST_F(Canboatjs, ReadsEveryLineOfAnExportAndTheValuesOfTheFrames) {
  const json read = reads(false);
  ASSERT_TRUE(read.is_object());
  EXPECT_EQ(read["refused"], 0);
  const json& messages = read["messages"];
  ASSERT_EQ(messages.size(), counts_.frames - 1) << "the last frame is a part of a fast packet";
  EXPECT_EQ(messages[0]["pgn"], 128267);
  EXPECT_EQ(messages[0]["src"], 116);
  EXPECT_EQ(messages[0]["fields"]["depth"], 2.08);
  EXPECT_EQ(messages[5]["pgn"], 127488);
  EXPECT_EQ(messages[5]["fields"]["speed"], 600);
  EXPECT_EQ(messages.back()["pgn"], 129025);
  EXPECT_EQ(messages.back()["fields"]["latitude"], record::test::sample_latitude_deg);
  EXPECT_EQ(messages.back()["fields"]["longitude"], record::test::sample_longitude_deg);
}

// Why an export says who sent a frame only where it is asked to.
TEST_F(Canboatjs, RefusesLinesThatSayWhoSent) {
  const json read = reads(true);
  ASSERT_TRUE(read.is_object());
  EXPECT_EQ(read["refused"], counts_.frames);
  EXPECT_TRUE(read["messages"].empty());
}

}  // namespace canboatjs_test
}  // namespace drydock::exporting
