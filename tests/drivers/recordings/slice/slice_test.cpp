#include "drivers/recordings/slice/slice.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <numbers>

#include "drivers/recordings/mcap/reader.hpp"
#include "tests/drivers/recordings/mcap/read_back.hpp"
#include "tests/drivers/recordings/sample_dive/sample_dive.hpp"

namespace drydock::slice {
namespace slice_test {

constexpr double degree = std::numbers::pi / 180;

/// Every place in the sample's bytes, degrees (from the notes of fixtures/ubx and nmea0183).
constexpr std::array latitudes_deg{47.2852332, -33.9456789, 41.5, 47.285233, 48.1173, 51.2418626};
constexpr std::array longitudes_deg{8.565265, -179.9999999, -71.0, 11.5166667, -0.2048967};

template <class Number>
bool holds(mcap::Bytes bytes, double value, double within) {
  for (std::size_t i = 0; i + sizeof(Number) <= bytes.size(); ++i) {
    Number number;
    std::memcpy(&number, bytes.data() + i, sizeof number);
    if (std::abs(static_cast<double>(number) - value) <= within) return true;
  }
  return false;
}

bool holds_text(mcap::Bytes bytes, std::string_view text) {
  return std::search(bytes.begin(), bytes.end(), text.begin(), text.end()) != bytes.end();
}

/// The form in which the bytes show one of the places. Empty if they do not.
std::string tells_place(mcap::Bytes bytes) {
  for (const auto* text : {"4717.11", "00833.9", "4807.03", "01131.0", "5114.51", "00012.2",
                           "4332.69", "17235.4", "47.28", "8.565", "Zurich", "lake"})
    if (holds_text(bytes, text)) return text;
  const auto in_a_form = [&](double deg) {
    return holds<std::int32_t>(bytes, deg * 1e7, 500) || holds<double>(bytes, deg, 1e-4) ||
           holds<double>(bytes, deg * degree, 1e-6);
  };
  for (const double deg : latitudes_deg)
    if (in_a_form(deg)) return std::to_string(deg);
  for (const double deg : longitudes_deg)
    if (in_a_form(deg)) return std::to_string(deg);
  // NAV-SOL 10 of fixtures/ubx, cm.
  for (const double ecef_cm : {428640618.0, 64560020.0, 466366904.0})
    if (holds<std::int32_t>(bytes, ecef_cm, 500)) return "ECEF";
  return {};
}

/// The messages and attachments of a file that show one of the places.
std::vector<std::string> places_in(const std::string& path) {
  mcap::Reader reader(std::make_unique<std::ifstream>(path, std::ios::binary));
  std::vector<std::string> found;
  while (const auto record = reader.next()) {
    std::string how;
    if (const auto* message = std::get_if<mcap::Message>(&*record))
      how = tells_place(message->data);
    if (const auto* attachment = std::get_if<mcap::Attachment>(&*record))
      how = tells_place({reinterpret_cast<const std::uint8_t*>(attachment->data.data()),
                         attachment->data.size()});
    if (!how.empty()) found.push_back(how);
  }
  return found;
}

class Slice : public testing::Test {
 protected:
  boost::system::result<Sliced, record::RecordingError> cut(const SliceOptions& options) {
    return slice(dive_, cut_, options, [](double) { return true; });
  }

  record::test::TestFolder folder_;
  std::string dive_ = folder_ / "dive.mcap", cut_ = folder_ / "cut.mcap";
  record::test::SampleCounts counts_ = record::test::write_sample_dive(dive_);
};

TEST_F(Slice, HasTheMessagesOfItsTimesAndNamesAndEveryAttachment) {
  SliceOptions options;
  options.part.only = {"dvl"};
  options.part.from = std::chrono::seconds{5};
  options.part.to = std::chrono::seconds{10};
  const auto done = cut(options);
  ASSERT_TRUE(done) << done.error().line;
  DRYDOCK_NEEDS_NODE();
  auto found = mcap::test::read_back(cut_);
  ASSERT_FALSE(found.contains("indexedError")) << found["indexedError"];
  const auto& topics = found["indexed"]["topics"];
  EXPECT_EQ(topics["/dvl/data"]["count"], 5);
  EXPECT_EQ(topics["/dvl/data"]["logTimes"][0], "1700000005000000000");
  EXPECT_FALSE(topics.contains("/gps/fix"));
  EXPECT_FALSE(topics.contains("/raw/can/can0"));
  EXPECT_EQ(found["indexed"]["attachments"].size(), 3U);
  EXPECT_EQ(found["indexed"]["statistics"]["messageCount"], std::to_string(done->messages));
}

TEST_F(Slice, ItsTimeIsShiftedInEveryStampOfTheBench) {
  SliceOptions options;
  options.start_at = measurement::stamp_from_ns(1'577'836'800'000'000'000);  // 2020-01-01
  const auto done = cut(options);
  ASSERT_TRUE(done) << done.error().line;
  DRYDOCK_NEEDS_NODE();
  auto found = mcap::test::read_back(cut_);
  const auto& topics = found["indexed"]["topics"];
  EXPECT_EQ(topics["/gps/fix"]["logTimes"][0], "1577836800000000000");
  EXPECT_EQ(topics["/gps/fix"]["first"]["header"]["stamp"]["sec"], 1'577'836'800);
  EXPECT_EQ(topics["/dvl/bottom_track"]["last"]["header"]["stamp"]["sec"], 1'577'836'819);
  EXPECT_EQ(topics["/raw/serial/dvl"]["first"]["stamp"]["sec"], 1'577'836'800);
  EXPECT_EQ(topics["/raw/can/can0"]["first"]["stamp"]["sec"], 1'577'836'800);
  EXPECT_THAT(found["indexed"]["attachments"][0]["text"].get<std::string>(),
              testing::Not(testing::HasSubstr("2026")));
}

TEST_F(Slice, NothingInItTellsThePlaceAnyMore) {
  ASSERT_THAT(places_in(dive_),
              testing::SizeIs(testing::Gt(20)));  // the search finds places that are there
  SliceOptions options;
  options.move_to = {0, -30 * degree};
  const auto done = cut(options);
  ASSERT_TRUE(done) << done.error().line;
  EXPECT_THAT(places_in(cut_), testing::IsEmpty());
  EXPECT_GT(done->moved, 40U);  // only from NavSatFix and GnssFix
  EXPECT_EQ(done->dropped.at("PGN 129029"), 1U);
  EXPECT_EQ(done->dropped.at("NMEA GSV"), 3U);
  EXPECT_EQ(done->dropped.at("UBX 02 15"), 1U);  // RXM-RAWX
  EXPECT_EQ(done->dropped.at("attachment chart.png"), 1U);
  DRYDOCK_NEEDS_NODE();
  auto found = mcap::test::read_back(cut_);
  const auto& topics = found["indexed"]["topics"];
  EXPECT_NEAR(topics["/gps/fix"]["last"]["latitude"].get<double>(), 0, 1e-9);
  EXPECT_NEAR(topics["/gps/fix"]["last"]["longitude"].get<double>(), -30, 1e-9);
  EXPECT_EQ(topics["/raw/serial/dvl"]["count"], counts_.dvl_reads + 1);
  EXPECT_EQ(topics["/raw/can/can0"]["count"], counts_.frames - 1);
  EXPECT_THAT(found["indexed"]["attachments"][1]["text"].get<std::string>(),
              testing::HasSubstr("longitude_deg = -30"));
}

TEST(DisguiseOfALine, WithoutARigFileBytesThatMayTellThePlaceAreDropped) {
  Disguise disguise({{}, measurement::Geodetic{}, {}}, {{"tcp:x", "x", false, {"gps"}}}, {});
  disguise.note({1, 1, "/raw/serial/x", "cdr", {}}, {1, record::raw_bytes_type, "ros2msg", ""}, 0);
  const std::array<std::uint8_t, 20> data{0, 1};
  bool kept = false;
  disguise.apply({1, 0, 0, 0, data}, [&](const mcap::Message&) { kept = true; });
  EXPECT_FALSE(kept);
  EXPECT_EQ(disguise.dropped().at("reads of an unknown line"), 1U);
}

/// Its position cannot be moved, because the bytes are in another order.
TEST(DisguiseOfAFix, OfAnotherByteOrderIsDropped) {
  Disguise disguise({{}, measurement::Geodetic{}, {}}, {}, {});
  disguise.note(
      {1, 1, "/gps/fix", "cdr", {}},
      {1, "sensor_msgs/msg/NavSatFix", "ros2msg", "float64 latitude\nfloat64 longitude\n"}, {});
  bool kept = false;
  const auto keep = [&](const mcap::Message&) { kept = true; };
  std::array<std::uint8_t, 20> data{0, 0};
  disguise.apply({1, 0, 0, 0, data}, keep);
  EXPECT_FALSE(kept);
  EXPECT_EQ(disguise.dropped().at("sensor_msgs/msg/NavSatFix"), 1U);
  data[1] = 1;
  disguise.apply({1, 0, 0, 0, data}, keep);
  EXPECT_TRUE(kept);
}

}  // namespace slice_test
}  // namespace drydock::slice
