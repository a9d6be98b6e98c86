// Files of estimates as other programs write them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <sstream>

#include "hil/score/numbers.hpp"
#include "hil/score/read_estimates.hpp"

namespace drydock::score {
namespace reading_test {

constexpr double degree = std::numbers::pi / 180;

TEST(ScoreFile, ATumLineIsEastNorthUpWithItsScalarLast) {
  std::istringstream in("# timestamp tx ty tz qx qy qz qw\n1795593600.000000123 3 4 5 0 0 0 1\n\n");
  const auto read = read_tum(in, "a.tum");
  ASSERT_TRUE(read) << read.error().line;
  ASSERT_EQ(read->track.size(), 1U);
  EXPECT_EQ(read->track.front().at.time_since_epoch().count(), 1795593600000000123);
  EXPECT_EQ(read->track.front().position_ned, Eigen::Vector3d(4, 3, -5));
  EXPECT_NEAR(read->track.front().angles.z(), 90 * degree, 1e-12) << "bow east";
}

TEST(ScoreFile, ACsvNamesItsColumnsInAnyOrder) {
  std::istringstream in(
      "east_m, t_s, north_m, down_m, heading_deg, roll_deg, pitch_deg, down_sigma_m, "
      "north_sigma_m, "
      "east_sigma_m\r\n2, 10.5, 1, 3, 90, 10, 0, 3, 1, 2\r\n");
  const auto read = read_csv(in, "a.csv", {});
  ASSERT_TRUE(read) << read.error().line;
  ASSERT_EQ(read->track.size(), 1U);
  EXPECT_EQ(read->track.front().at.time_since_epoch().count(), 10'500'000'000);
  EXPECT_EQ(read->track.front().position_ned, Eigen::Vector3d(1, 2, 3));
  EXPECT_NEAR(read->track.front().angles.x(), 10 * degree, 1e-12);
  EXPECT_EQ((*read->track.front().position_m2)(1, 1), 4);
}

TEST(ScoreFile, DegreesAreMetresFromTheFirstTruth) {
  std::istringstream in("valid_at_ns,latitude_deg,longitude_deg,height_m\n7,60.001,5,-2\n");
  const auto read = read_csv(in, "a.csv", {60 * degree, 5 * degree, 0});
  ASSERT_TRUE(read) << read.error().line;
  EXPECT_EQ(read->track.front().at.time_since_epoch().count(), 7);
  // A minute of latitude at 60 degrees is 1857 m on WGS-84.
  EXPECT_NEAR(read->track.front().position_ned.x(), 0.06 * 1857, 0.1);
  EXPECT_NEAR(read->track.front().position_ned.z(), 2, 1e-2);
}

TEST(ScoreFile, WhatIsWrongIsSaidWithItsLine) {
  const auto tum = [](const char* text) {
    std::istringstream in(text);
    return read_tum(in, "a.tum").error().line;
  };
  EXPECT_EQ(tum("1 2 3\n"), "a.tum:1: not t x y z qx qy qz qw");
  EXPECT_EQ(tum("# c\n1 0 0 0 0 0 0 0\n"),
            "a.tum:2: the quaternion's length is 0, allowed: 0.99 to 1.01");
  EXPECT_EQ(tum("1 nan 0 0 0 0 0 1\n"), "a.tum:1: a value of the pose is no number");
  EXPECT_EQ(tum("inf 0 0 0 0 0 0 1\n"),
            "a.tum:1: \"inf\" is no time in seconds (since 1970, or of the truth's clock)");
  EXPECT_EQ(tum("1 0 0 0 0 0 0 3.7\n"),
            "a.tum:1: the quaternion's length is 3.7, allowed: 0.99 to 1.01");
  EXPECT_EQ(tum("1 0 0 0 0 0 0 1 1\n"), "a.tum:1: not t x y z qx qy qz qw");
  const auto csv = [](const char* text) {
    std::istringstream in(text);
    return read_csv(in, "a.csv", {}).error().line;
  };
  EXPECT_EQ(csv("north_m,east_m,down_m\n1,2,3\n"),
            "a.csv:1: no column valid_at_ns or t_s or utc; there are: north_m, east_m, down_m");
  EXPECT_THAT(csv("t_s,x\x1B[2J,b,c\n1,2,3,4\n"),
              testing::AllOf(testing::HasSubstr("a.csv:1: no column of a position, an attitude or "
                                                "a velocity: latitude_deg, longitude_deg"),
                             testing::HasSubstr("there are: t_s, x?[2J, b, c")));
  EXPECT_EQ(csv("t_s,t_s,north_m,east_m,down_m\n"), "a.csv:1: two columns are named t_s");
  EXPECT_EQ(csv("t_s,north_m,east_m,down_m\n1,2,3,4\n2,x,3,4\n"),
            "a.csv:3: north_m = \"x\" is no number");
  EXPECT_EQ(csv("t_s,north_m\n1,inf\n"), "a.csv:2: north_m = \"inf\" is no number");
  EXPECT_EQ(csv("t_s,north_m\nnoon,1\n"), "a.csv:2: t_s = \"noon\" is no time");
  EXPECT_EQ(csv("t_s,longitude_deg,latitude_deg,height_m\n1,33,129,0\n"),
            "a.csv:2: latitude_deg = 129, allowed: -90 to 90");
  EXPECT_EQ(csv("t_s,longitude_deg,latitude_deg,height_m\n1,500,33,0\n"),
            "a.csv:2: longitude_deg = 500, allowed: -360 to 360");
}

std::int64_t ns_of(const std::optional<measurement::Stamp>& stamp) {
  return stamp ? stamp->time_since_epoch().count() : -1;
}

TEST(ScoreFile, ATimeKeepsItsNanoseconds) {
  EXPECT_EQ(ns_of(stamp_of_seconds("1795593600.123456789")), 1795593600123456789);
  EXPECT_EQ(ns_of(stamp_of_seconds("5")), 5'000'000'000);
  EXPECT_EQ(ns_of(stamp_of_seconds(".5")), 500'000'000);
  EXPECT_EQ(stamp_of_seconds("-1.25")->time_since_epoch().count(), -1'250'000'000);
  for (const auto* bad : {"", "x", "1..2", "1e30", "nan", "inf", "1e", "1e+-3", "e5", ".", "1.2e3x",
                          "9300000000", "0x10"})
    EXPECT_FALSE(stamp_of_seconds(bad)) << bad;
}

// The first three are what numpy.savetxt writes by default ("%.18e") for 1700000000.0, 0.14, 0.3.
TEST(ScoreFile, ATimeMayHaveAnExponent) {
  EXPECT_EQ(ns_of(stamp_of_seconds("1.700000000000000000e+09")), 1'700'000'000'000'000'000);
  EXPECT_EQ(ns_of(stamp_of_seconds("1.400000000000000133e-01")), 140'000'000);
  EXPECT_EQ(ns_of(stamp_of_seconds("2.999999999999999889e-01")), 300'000'000);
  EXPECT_EQ(ns_of(stamp_of_seconds("1.795593600123456789E9")), 1795593600123456789);
  EXPECT_EQ(ns_of(stamp_of_seconds("17955936001234567.89e-7")), 1795593600123456789);
  EXPECT_EQ(ns_of(stamp_of_seconds("1.5e3")), 1'500'000'000'000);
  EXPECT_EQ(ns_of(stamp_of_seconds("1e-400")), 0);
}

TEST(ScoreFile, NanosecondsAreAWholeNumber) {
  EXPECT_EQ(ns_of(stamp_of_nanoseconds("1795248000034345136")), 1795248000034345136);
  EXPECT_EQ(ns_of(stamp_of_nanoseconds("1.795248000034345216e+18")), 1795248000034345216);
  EXPECT_EQ(ns_of(stamp_of_nanoseconds("7.0")), 7);
  EXPECT_FALSE(stamp_of_nanoseconds("1795248000.0343451")) << "these are seconds";
  EXPECT_FALSE(stamp_of_nanoseconds("1e19"));
}

TEST(ScoreFile, WhatIsPassedOverIsCountedAndSaid) {
  std::istringstream in(
      "\xEF\xBB\xBFt_s,valid_at_ns,north_m,east_m,down_m,qw,north_sigma_m,east_sigma_m,"
      "down_sigma_m\n"
      "1,1000000000,1,2,3,0,1,1,1\n"
      "2,2000000000,1,2,3,0,-1,1,1\n"
      "9,3000000000,1,2,3,0,1,1,1\n"
      "4,4000000000,1,2\n"
      "5,5000000000,1,2,3,0,1,1,1,8\n"
      "6,6000000000,1,2,3,0,0,0,0\n"
      "7,7000000000,1,2,3,0,1,1,1,,\n");
  const auto read = read_csv(in, "a.csv", {});
  ASSERT_TRUE(read) << read.error().line;
  ASSERT_EQ(read->track.size(), 5U);
  EXPECT_EQ(read->track[2].at.time_since_epoch().count(), 3'000'000'000);
  EXPECT_TRUE(read->track[0].position_m2 && !read->track[1].position_m2);
  EXPECT_THAT(
      read->notes,
      testing::ElementsAre(
          "column qw is not read: it needs all of qw, qx, qy, qz",
          "a standard deviation is not above 0, the covariance is left out: 2 lines, the first is "
          "line 3",
          "t_s is not the time of valid_at_ns, which is taken: 1 line, the first is line 4",
          "not the 9 cells of line 1, left out: 2 lines, the first is line 5"));
}

}  // namespace reading_test
}  // namespace drydock::score
