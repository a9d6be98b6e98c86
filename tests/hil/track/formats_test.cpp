#include "hil/track/formats.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

namespace drydock::track {
namespace {

/// Two points of a track on the meridian of 129 degrees east, half a second apart, and a fix.
Outcome two_points() {
  Outcome outcome;
  outcome.has_heights = true;
  outcome.gathered.source = "a<b&c.mcap";
  outcome.gathered.utc = outcome.gathered.start =
      measurement::stamp_from_ns(1'795'248'000'000'000'000);
  smoothing::TrackPoint point;
  point.position = {M_PI / 5, 129 * M_PI / 180, -12.5};  // 36 degrees north
  point.velocity_ned = {1.5, 0, 0};
  point.attitude.yaw = -M_PI / 2;
  point.position_covariance = Eigen::Vector3d{4, 9, 1}.asDiagonal();
  point.position_covariance(0, 1) = point.position_covariance(1, 0) = 3;
  outcome.track.smoothed.push_back(point);
  point.time_s = 0.5;
  outcome.track.smoothed.push_back(point);
  outcome.gathered.dive.readings.push_back(
      {0, smoothing::Quantity::fix, 0, {M_PI / 6, 0, 3}, {1, 1, 1}});
  return outcome;
}

TEST(TrackFormats, GeoJsonHasLongitudeBeforeLatitudeAndTheFixesBesideTheLine) {
  const auto outcome = two_points();
  const auto json = nlohmann::json::parse(to_geojson(outcome, thinned(outcome, 0)));
  EXPECT_EQ(json["type"], "FeatureCollection");
  const auto& line = json["features"][0];
  EXPECT_EQ(line["geometry"]["type"], "LineString");
  ASSERT_EQ(line["geometry"]["coordinates"].size(), 2U);
  const auto& first = line["geometry"]["coordinates"][0];
  EXPECT_NEAR(first[0], 129, 1e-12);
  EXPECT_NEAR(first[1], 36, 1e-12);
  EXPECT_NEAR(first[2], -12.5, 1e-12);
  EXPECT_EQ(line["properties"]["times"][1], "2026-11-21T08:00:00.500Z");
  EXPECT_NEAR(line["properties"]["sigma_east_m"][0], 3, 1e-12);
  EXPECT_EQ(json["features"][1]["geometry"]["type"], "Point");
  EXPECT_NEAR(json["features"][1]["geometry"]["coordinates"][1], 30, 1e-12);
}

TEST(TrackFormats, GpxIsEscapedAndHasTheTimeOfEachPoint) {
  const auto outcome = two_points();
  const auto gpx = to_gpx(outcome, thinned(outcome, 0));
  EXPECT_NE(gpx.find("<name>a&lt;b&amp;c.mcap</name>"), std::string::npos);
  EXPECT_NE(gpx.find("<trkpt lat=\"36.000000000\" lon=\"129.000000000\"><ele>-12.500</ele>"
                     "<time>2026-11-21T08:00:00.000Z</time></trkpt>"),
            std::string::npos);
  EXPECT_TRUE(gpx.ends_with("</gpx>\n"));
}

TEST(TrackFormats, EveryLineOfACsvHasTheColumnsOfTheFirst) {
  const auto outcome = two_points();
  std::istringstream csv(to_csv(outcome, thinned(outcome, 0)));
  std::string line, last;
  int lines = 0;
  for (; std::getline(csv, line); ++lines) {
    EXPECT_EQ(std::ranges::count(line, ','), 15) << line;
    last = line;
  }
  EXPECT_EQ(lines, 3);
  EXPECT_EQ(last,
            "0.500000,2026-11-21T08:00:00.500Z,36.000000000,129.000000000,-12.5000,1.50000,"
            "0.00000,0.00000,0.0000,0.0000,270.0000,2.0000,3.0000,1.0000,0.5000,0.0000");
}

/// RFC 7946, section 3.1.1: a position has two elements, and a third one if there is a height.
TEST(TrackFormats, AHeightThatNobodyToldIsLeftOut) {
  auto outcome = two_points();
  outcome.has_heights = false;
  outcome.gathered.dive.readings[0].value.z() = std::numeric_limits<double>::quiet_NaN();
  const auto points = thinned(outcome, 0);
  const auto json = nlohmann::json::parse(to_geojson(outcome, points));
  EXPECT_EQ(json["features"][0]["geometry"]["coordinates"][0].size(), 2U);
  EXPECT_EQ(json["features"][1]["geometry"]["coordinates"].size(), 2U);
  EXPECT_EQ(to_gpx(outcome, points).find("<ele>"), std::string::npos);
  EXPECT_NE(to_csv(outcome, points).find(",129.000000000,,1.50000,"), std::string::npos);
  EXPECT_NE(to_csv(outcome, points).find(",2.0000,3.0000,,0.5000,"), std::string::npos);
}

TEST(TrackFormats, AThinnedTrackKeepsItsLastPoint) {
  const auto outcome = two_points();
  EXPECT_EQ(thinned(outcome, 10).size(), 2U);
  EXPECT_EQ(thinned(outcome, 0.5).size(), 2U);
}

TEST(TrackFormats, OnlyTheFourNamesAreFormats) {
  for (const char* name : {"geojson", "gpx", "csv", "mcap"}) EXPECT_TRUE(format_of(name)) << name;
  for (const char* name : {"", "kml", "CSV"}) EXPECT_FALSE(format_of(name)) << name;
}

}  // namespace
}  // namespace drydock::track
