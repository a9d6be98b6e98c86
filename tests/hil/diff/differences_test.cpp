#include "hil/diff/differences.hpp"

#include <gtest/gtest.h>

namespace differences_test {

using drydock::diff::compare;
using drydock::diff::Comparison;
using drydock::diff::Difference;
using drydock::diff::Json;

Json run(int bad_checksums, double rms) {
  return {{"rig", "demo"},
          {"wall_s", rms},
          {"resident", {{"end_mb", bad_checksums}}},
          {"devices",
           {{{"name", "dvl"}, {"bad_checksums", bad_checksums}, {"rate_hz", 8.0}},
            {{"name", "imu"}, {"bad_checksums", 0}, {"rate_hz", 100.0}}}},
          {"estimators", {{{"name", "nav"}, {"navigation", {{"horizontal_rms_m", rms}}}}}}};
}

std::vector<std::string> names(const Comparison& comparison) {
  std::vector<std::string> all;
  for (const auto& one : comparison.differences) all.push_back(one.what);
  return all;
}

TEST(Differences, OfARunAndItselfAreNone) {
  const auto comparison = compare(run(3, 2), run(3, 2));
  EXPECT_TRUE(comparison.differences.empty());
  EXPECT_EQ(comparison.compared, 9U);  // the rig, three of each device, two of the estimator
}

TEST(Differences, NameTheDeviceAndTheEstimatorAndSayByHowMuch) {
  const auto comparison = compare(run(3, 2), run(5, 2.5));
  ASSERT_EQ(names(comparison),
            (std::vector<std::string>{"device dvl: bad_checksums",
                                      "estimator nav: navigation horizontal_rms_m"}));
  EXPECT_EQ(comparison.differences[0].a, Json(3));
  EXPECT_EQ(comparison.differences[0].b, Json(5));
  EXPECT_EQ(comparison.differences[0].change, 2);
  EXPECT_EQ(comparison.differences[1].change, 0.5);
}

TEST(Differences, WithinTheToleranceAreNone) {
  EXPECT_TRUE(compare(run(3, 2), run(3, 2.02), 0.01).differences.empty());
  EXPECT_EQ(compare(run(3, 2), run(3, 2.03), 0.01).differences.size(), 1U);
}

TEST(Differences, ADeviceIsTheSameByItsNameWhereverItStands) {
  Json turned = run(3, 2);
  std::swap(turned["devices"][0], turned["devices"][1]);
  EXPECT_TRUE(compare(run(3, 2), turned).differences.empty());
}

TEST(Differences, WhatOnlyOneRunHasIsNamedAndTheOtherSideIsEmpty) {
  Json more = run(3, 2);
  more["devices"].push_back({{"name", "gps"}, {"rate_hz", 5}});
  more["notes"] = {"recording x.mcap"};
  const auto comparison = compare(run(3, 2), more);
  EXPECT_EQ(names(comparison), (std::vector<std::string>{"device gps", "notes recording x.mcap"}));
  EXPECT_FALSE(comparison.differences[0].a);
  EXPECT_EQ(comparison.differences[0].b, Json("present"));
  EXPECT_EQ(names(compare(more, run(3, 2))), names(comparison));
}

TEST(Differences, TwoFindingsOfOneNameAreTwo) {
  const Json finding{{"device", "dvl"}, {"cause", "damaged"}, {"since_s", 1.5}};
  const Json once{{"findings", {finding}}}, twice{{"findings", {finding, finding}}};
  EXPECT_EQ(names(compare(once, twice)), (std::vector<std::string>{"finding dvl damaged 1.5 (2)"}));
}

TEST(Differences, OfVerdictsAreThoseOfTheirNumbers) {
  const auto judged = [](const char* measured) {
    return Json{{"expectations", {{{"of", "dvl"}, {"what", "rate_hz"}, {"measured", measured}}}}};
  };
  EXPECT_TRUE(compare(judged("8.0"), judged("8.004"), 0.01).differences.empty());
  const auto comparison = compare(judged("8"), judged("6.5"), 0.01);
  ASSERT_EQ(names(comparison), std::vector<std::string>{"expectation dvl rate_hz: measured"});
  EXPECT_EQ(comparison.differences[0].change, -1.5);
}

}  // namespace differences_test
