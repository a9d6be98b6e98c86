// An estimator in another program is judged as one of ours. All numbers are closed forms.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/hil/outside/outside_rig.hpp"

namespace judged_test {

using namespace outside_rig;

TEST(OutsideEstimator, AnOffsetIsItsErrorAndItsSquareOverTheSigmaTheNees) {
  const Folder folder;
  const auto summary =
      run(folder, one_imu + estimator("attitude"),
          client("{'roll_deg': 1.0, 'pitch_deg': -2.0, 'attitude_sigma_deg': [1, 1, 1]}"), 10);
  const auto& mine = summary.estimators.at(0);
  EXPECT_EQ(mine.kind, "external");
  EXPECT_EQ(mine.estimates, summary.devices.at(0).messages);
  ASSERT_TRUE(mine.whole_run);
  EXPECT_NEAR(mine.whole_run->roll_rms_deg, 1, 1e-9);
  EXPECT_NEAR(mine.whole_run->pitch_rms_deg, 2, 1e-9);
  EXPECT_NEAR(mine.whole_run->pitch_max_deg, 2, 1e-9);
  EXPECT_NEAR(mine.whole_run->nees_mean, (1 + 4) / 2.0, 1e-9);
  EXPECT_THAT(to_text(summary), testing::HasSubstr("pitch 2.000 deg RMS, NEES 2.50"));
  EXPECT_TRUE(std::isnan(mine.whole_run->settling_s)) << "2 degrees off to the end";
  EXPECT_NEAR(mine.rate_hz.value(), 100, 0.1);
  EXPECT_EQ(mine.valid_share, 1.0);
}

TEST(OutsideEstimator, HasSettledWhenItStaysWithinADegree) {
  const Folder folder;
  const auto summary = run(folder, one_imu + estimator("attitude"),
                           client("{'roll_deg': 5.0 if t < 3 else 0.5, 'pitch_deg': 0.0}"), 10);
  ASSERT_TRUE(summary.estimators.at(0).whole_run);
  EXPECT_NEAR(summary.estimators[0].whole_run->settling_s, 3, 0.05);
  EXPECT_TRUE(std::isnan(summary.estimators[0].whole_run->nees_mean)) << "it gives no covariance";
  const auto json = nlohmann::json::parse(to_json(summary))["estimators"][0];
  EXPECT_TRUE(json["whole_run"]["nees_mean"].is_null());
  EXPECT_NEAR(json["whole_run"]["settling_s"], 3, 0.05);
}

TEST(OutsideEstimator, TheShareOfWhatItCallsValidCounts) {
  const Folder folder;
  const auto summary = run(folder, one_imu + estimator("attitude"),
                           client("{'roll_deg': 0, 'pitch_deg': 0, 'valid': t >= 2.5}"), 10);
  EXPECT_NEAR(summary.estimators.at(0).valid_share.value(), 0.75, 0.005);
}

TEST(OutsideEstimator, APositionThatStaysIsOffByTheWay) {
  const Folder folder;
  const auto summary =
      run(folder, one_imu + estimator("navigation"),
          client("{'latitude_deg': 36.0, 'longitude_deg': 129.0, 'height_m': -10.0, "
                 "'position_sigma_m': [50, 50, 1]}"),
          10);
  const auto& mine = summary.estimators.at(0);
  ASSERT_TRUE(mine.navigation);
  EXPECT_NEAR(mine.navigation->horizontal_end_m, 100, 0.6);
  EXPECT_NEAR(mine.navigation->horizontal_rms_m, 100 / std::sqrt(3), 0.5);
  EXPECT_NEAR(mine.navigation->depth_rms_m, 0, 0.01);
  EXPECT_NEAR(mine.navigation->nees_position, 100. * 100 / 3 / (50 * 50) / 2, 0.02);
  EXPECT_TRUE(std::isnan(mine.navigation->velocity_rms_mps)) << "it gives no velocity";
  EXPECT_FALSE(mine.whole_run) << "it gives no attitude";
  EXPECT_THAT(to_html(summary),
              testing::HasSubstr("velocity over ground<td data-label=\"RMS\">none"));
}

TEST(OutsideEstimator, AVelocityAloneHasItsError) {
  const Folder folder;
  const auto summary = run(folder, one_imu + estimator("velocity"),
                           client("{'velocity_ned_mps': [10.3, 0.4, 0.0]}"), 10);
  const auto& mine = summary.estimators.at(0);
  ASSERT_TRUE(mine.navigation);
  EXPECT_NEAR(mine.navigation->velocity_rms_mps, 0.5, 1e-6);
  EXPECT_NEAR(mine.navigation->velocity_max_mps, 0.5, 1e-6);
  EXPECT_TRUE(std::isnan(mine.navigation->horizontal_rms_m));
}

TEST(OutsideEstimator, IsExpectedOfLikeOurOwn) {
  const Folder folder;
  const std::string expects = R"(
[[expect]]
estimator = "mine"
roll_rms_deg_max = 1.1
pitch_rms_deg_max = 1.9
nees = [2.4, 2.6]
estimate_rate_hz = [99, 101]
settling_s_max = 5
valid_share_min = 1
answer_ms_max = 1000
[[expect]]
estimator = "mine"
after_s = 5
estimates_min = 490
)";
  const auto summary =
      run(folder, one_imu + estimator("attitude") + expects,
          client("{'roll_deg': 1.0, 'pitch_deg': -2.0, 'attitude_sigma_deg': [1, 1, 1]}"), 10);
  std::map<std::string, bool> passed;
  for (const auto& verdict : summary.verdicts) passed[verdict.what] = verdict.passed;
  const std::map<std::string, bool> expected{
      {"answers", true},     {"roll_rms_deg", true},     {"pitch_rms_deg", false},
      {"nees", true},        {"estimate_rate_hz", true}, {"settling_s", false},
      {"valid_share", true}, {"answer_ms", true},        {"estimates", true}};
  EXPECT_EQ(passed, expected);
}

}  // namespace judged_test
