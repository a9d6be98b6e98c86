#include "estimators/external/answer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "estimators/frame/attitude.hpp"

namespace drydock::external {
namespace answer_test {

using Flaw = Answer::Flaw;
constexpr double degree = std::numbers::pi / 180;

pipeline::AttitudeEstimate attitude(const Answer& answer, std::size_t i = 0) {
  return std::get<pipeline::AttitudeEstimate>(answer.estimates.at(i));
}
pipeline::NavigationEstimate navigation(const Answer& answer, std::size_t i = 0) {
  return std::get<pipeline::NavigationEstimate>(answer.estimates.at(i));
}

TEST(Answer, TheExampleOfThePageIsOneAttitude) {
  const auto answer = read_answer(
      R"({"step":1,"estimates":[{"valid_at_ns":1795593600010000000,"roll_deg":0.117,"pitch_deg":0.058,)"
      R"("attitude_sigma_deg":[5.0,4.0,180.0]}]})",
      Gives::attitude);
  EXPECT_EQ(answer.flaw, Flaw::none) << answer.what;
  EXPECT_EQ(answer.step, 1U);
  ASSERT_EQ(answer.estimates.size(), 1U);
  EXPECT_EQ(attitude(answer).valid_at.time_since_epoch().count(), 1795593600010000000);
  EXPECT_DOUBLE_EQ(attitude(answer).roll_rad, 0.117 * degree);
  EXPECT_DOUBLE_EQ(attitude(answer).pitch_rad, 0.058 * degree);
  EXPECT_FALSE(attitude(answer).yaw_rad);
  EXPECT_DOUBLE_EQ(attitude(answer).covariance(0, 0), 25 * degree * degree);
  EXPECT_DOUBLE_EQ(attitude(answer).covariance(1, 1), 16 * degree * degree);
  EXPECT_EQ(attitude(answer).covariance(0, 1), 0);
  EXPECT_TRUE(attitude(answer).integrity.valid);
  EXPECT_NEAR(attitude(answer).integrity.roll_bound_rad, 5.3267 * 5 * degree, 1e-12);
}

TEST(Answer, WithoutACovarianceItsBoundsAreInfinite) {
  const auto answer = read_answer(
      R"({"step":2,"estimates":[{"valid_at_ns":5,"roll_deg":1,"pitch_deg":2,"valid":false}]})",
      Gives::attitude);
  ASSERT_EQ(answer.estimates.size(), 1U);
  EXPECT_TRUE(std::isnan(attitude(answer).covariance(0, 0)));
  EXPECT_TRUE(std::isinf(attitude(answer).integrity.pitch_bound_rad));
  EXPECT_FALSE(attitude(answer).integrity.valid);
}

TEST(Answer, ANavigationHasItsNineNumbersInRowsAndItsAnglesAsARotation) {
  const auto answer = read_answer(
      R"({"step":7,"estimates":[{"valid_at_ns":9,"latitude_deg":59.5,"longitude_deg":-10.25,"height_m":-42,)"
      R"("velocity_ned_mps":[1,2,3],"roll_deg":10,"pitch_deg":0,"heading_deg":90,)"
      R"("position_covariance_m2":[4,1,0,1,9,0,0,0,16],"velocity_sigma_mps":[0.1,0.2,0.3],)"
      R"("attitude_sigma_deg":[1,2,3]}]})",
      Gives::navigation);
  ASSERT_EQ(answer.flaw, Flaw::none) << answer.what;
  const auto estimate = navigation(answer);
  EXPECT_DOUBLE_EQ(estimate.position.latitude_rad, 59.5 * degree);
  EXPECT_DOUBLE_EQ(estimate.position.longitude_rad, -10.25 * degree);
  EXPECT_DOUBLE_EQ(estimate.position.height_m, -42);
  EXPECT_EQ(estimate.velocity_ned, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(estimate.covariance(0, 1), 1);
  EXPECT_EQ(estimate.covariance(1, 1), 9);
  EXPECT_EQ(estimate.covariance(2, 2), 16);
  EXPECT_DOUBLE_EQ(estimate.covariance(4, 4), 0.04);
  EXPECT_NEAR(frame::euler(estimate.body_to_ned).roll, 10 * degree, 1e-12);
  EXPECT_NEAR(frame::euler(estimate.body_to_ned).yaw, 90 * degree, 1e-12);
  // At heading 90 deg a change of roll turns about east and one of pitch about -north.
  EXPECT_NEAR(estimate.covariance(6, 6), 4 * degree * degree, 1e-15);
  EXPECT_NEAR(estimate.covariance(7, 7), 1 * degree * degree, 1e-15);
  EXPECT_NEAR(estimate.covariance(8, 8), 9 * degree * degree, 1e-15);
  const auto angles = pipeline::euler_covariance(estimate);
  EXPECT_NEAR(angles(0, 0), 1 * degree * degree, 1e-15);
  EXPECT_NEAR(angles(1, 1), 4 * degree * degree, 1e-15);
}

TEST(Answer, WhatAVelocityDoesNotGiveIsNotANumber) {
  const auto answer = read_answer(
      R"({"step":1,"estimates":[{"valid_at_ns":9,"velocity_ned_mps":[1,0,0]}]})", Gives::velocity);
  ASSERT_EQ(answer.flaw, Flaw::none) << answer.what;
  EXPECT_EQ(navigation(answer).velocity_ned.x(), 1);
  EXPECT_TRUE(std::isnan(navigation(answer).position.latitude_rad));
  EXPECT_TRUE(std::isnan(navigation(answer).body_to_ned.w()));
}

struct Bad {
  const char* line;
  Flaw flaw;
  std::uint64_t step;
};

TEST(Answer, EachSortOfBadLineHasItsFlaw) {
  for (
      const auto& [line, flaw, step] : {
          Bad{"", Flaw::malformed, 0},
          Bad{"[]", Flaw::malformed, 0},
          Bad{"{\"step\":-1,\"estimates\":[]}", Flaw::malformed, 0},
          Bad{"{\"step\":\"1\",\"estimates\":[]}", Flaw::malformed, 0},
          Bad{"{\"step\":4}", Flaw::malformed, 4},
          Bad{"{\"step\":4,\"estimates\":{}}", Flaw::malformed, 4},
          Bad{"{\"step\":4,\"estimates\":[3]}", Flaw::malformed, 4},
          Bad{R"({"step":4,"estimates":[{"roll_deg":1,"pitch_deg":1}]})", Flaw::malformed, 4},
          Bad{R"({"step":4,"estimates":[{"valid_at_ns":1.5,"roll_deg":1,"pitch_deg":1}]})",
              Flaw::malformed, 4},
          Bad{R"({"step":4,"estimates":[{"valid_at_ns":1,"roll_deg":1}]})", Flaw::malformed, 4},
          Bad{R"({"step":4,"estimates":[{"valid_at_ns":1,"roll_deg":"1","pitch_deg":1}]})",
              Flaw::malformed, 4},
          Bad{R"({"step":4,"estimates":[{"valid_at_ns":1,"roll_deg":1,"pitch_deg":91}]})",
              Flaw::malformed, 4},
          Bad{R"({"step":4,"estimates":[{"valid_at_ns":1,"roll_deg":1,"pitch_deg":1,"attitude_sigma_deg":[1,2]}]})",
              Flaw::malformed, 4},
          Bad{R"({"step":4,"estimates":[{"valid_at_ns":1,"roll_deg":1,"pitch_deg":1,"attitude_covariance_deg2":[1,2,0,2,1,0,0,0,1]}]})",
              Flaw::malformed, 4},
          Bad{R"({"step":4,"estimates":[{"valid_at_ns":1,"roll_deg":null,"pitch_deg":1}]})",
              Flaw::not_finite, 4},
          Bad{R"({"step":4,"estimates":[{"valid_at_ns":1,"roll_deg":NaN,"pitch_deg":1}]})",
              Flaw::not_finite, 0},
          Bad{R"({"step":4,"estimates":[{"valid_at_ns":1,"roll_deg":-Infinity,"pitch_deg":1}]})",
              Flaw::not_finite, 0},
      }) {
    const auto answer = read_answer(line, Gives::attitude);
    EXPECT_EQ(answer.flaw, flaw) << line;
    EXPECT_EQ(answer.step, step) << line;
    EXPECT_TRUE(answer.estimates.empty()) << line;
    EXPECT_NE(answer.what, "") << line;
  }
}

/// An answer with one estimate that has these members too.
Answer with(const std::string& members) {
  return read_answer(R"({"step":4,"estimates":[{"valid_at_ns":1,"pitch_deg":1,)" + members + "}]}",
                     Gives::attitude);
}

TEST(Answer, AFlawNamesItsField) {
  const auto what = [](const char* members) { return with(members).what; };
  EXPECT_EQ(what(R"("roll_deg":-Infinity)"), "roll_deg: Infinity, which JSON does not have");
  EXPECT_EQ(what(R"("roll_deg":1,"attitude_sigma_deg":[1,NaN,1])"),
            "attitude_sigma_deg: NaN, which JSON does not have");
  EXPECT_EQ(what(R"("roll_deg":1,"attitude_sigma_deg":[1,-1,1])"),
            "attitude_sigma_deg that is negative");
  EXPECT_EQ(what(R"("roll_deg":1,"valid":"true")"), "valid that is neither true nor false");
  EXPECT_EQ(what(R"("roll_deg":1,"valid":1)"), "valid that is neither true nor false");
  EXPECT_EQ(what(R"("roll_deg":1,"valid":true)"), "");
  EXPECT_THAT(what(R"("roll_deg":infinite)"), testing::HasSubstr("which is not JSON"));
}

TEST(Answer, AMisspeltKeyIsNamedWithThoseThatAreRead) {
  const auto answer = with(R"("roll_deg":1,"atitude_sigma_deg":[1,1,1])");
  EXPECT_EQ(answer.flaw, Flaw::malformed);
  EXPECT_THAT(answer.what,
              testing::StartsWith("the key atitude_sigma_deg, allowed: valid_at_ns, roll_deg, "));
}

/// 1e999 is JSON; RFC 8259 lets its reader limit the range of numbers.
TEST(Answer, ANumberBeyondEveryDoubleIsAnInfinity) {
  const auto answer = with(R"("roll_deg":-1e999)");
  EXPECT_EQ(answer.flaw, Flaw::not_finite);
  EXPECT_EQ(answer.what, "-1e999, which is beyond every number here: an infinity");
}

TEST(Answer, AMatrixThatIsNoCovarianceHasItsReason) {
  const auto what = [](const char* nine) {
    return with(R"("roll_deg":1,"attitude_covariance_deg2":)" + std::string(nine)).what;
  };
  EXPECT_EQ(what("[1,0.5,0,0.5,1,0,0,0,1]"), "");
  EXPECT_EQ(what("[1,0.9,0,-0.9,1,0,0,0,1]"),
            "attitude_covariance_deg2 that is no covariance: it is not symmetric");
  EXPECT_EQ(what("[1,-0.9,-0.9,-0.9,1,-0.9,-0.9,-0.9,1]"),
            "attitude_covariance_deg2 that is no covariance: it has a direction with a negative "
            "variance");
}

TEST(Answer, DeviationsAndACovarianceMustAgree) {
  const auto what = [](const char* sigmas) {
    return with(R"("roll_deg":1,"attitude_covariance_deg2":[4,1,0,1,9,0,0,0,16],)"
                R"("attitude_sigma_deg":)" +
                std::string(sigmas));
  };
  EXPECT_EQ(what("[2,3,5]").what, "attitude_sigma_deg and attitude_covariance_deg2 that disagree");
  EXPECT_EQ(what("[2,3,4]").what, "");
  EXPECT_DOUBLE_EQ(attitude(what("[2,3,4]")).covariance(0, 1), degree * degree);
}

TEST(Answer, AHeadingMayHaveCountedItsTurns) {
  for (const auto& [heading, same] : {std::pair{"725", 5.0}, {"-350", 10.0}, {"270", -90.0}}) {
    const auto answer = with(R"("roll_deg":1,"heading_deg":)" + std::string(heading));
    ASSERT_EQ(answer.flaw, Flaw::none) << answer.what;
    EXPECT_NEAR(attitude(answer).yaw_rad.value(), same * degree, 1e-12) << heading;
  }
}

TEST(Answer, TheEstimatesBeforeTheFlawAreKept) {
  const auto answer = read_answer(
      R"({"step":4,"estimates":[{"valid_at_ns":1,"roll_deg":3,"pitch_deg":1},{"valid_at_ns":2}]})",
      Gives::attitude);
  EXPECT_EQ(answer.flaw, Flaw::malformed);
  ASSERT_EQ(answer.estimates.size(), 1U);
  EXPECT_DOUBLE_EQ(attitude(answer).roll_rad, 3 * degree);
}

}  // namespace answer_test
}  // namespace drydock::external
