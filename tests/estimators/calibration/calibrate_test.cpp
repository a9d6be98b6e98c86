#include "estimators/calibration/calibrate.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "tests/estimators/smoothing/dive_of.hpp"

namespace drydock::calibration {
namespace {

using smoothing::Quantity;
using smoothing::test::drawn;
using smoothing::test::Drawn;
using smoothing::test::options_of;
using smoothing::test::Voyage;

constexpr double degree = M_PI / 180;
constexpr double yaw = 3 * degree, scale = 0.02;

/// A DVL that is mounted 3 degrees too far to starboard and measures 2 % too much.
Drawn wrong_dive(std::uint64_t seed) {
  Drawn dive = drawn(Voyage(600), seed);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(-yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  for (auto& reading : dive.dive.readings)
    if (reading.quantity == Quantity::bottom) reading.value = (1 + scale) * (turn * reading.value);
  return dive;
}

const std::vector<Parameter> both{{0, Unknown::yaw, usual_prior(Unknown::yaw)},
                                  {0, Unknown::scale, usual_prior(Unknown::scale)}};

TEST(Calibrate, FindsYawAndScaleOfADvlWithinItsBounds) {
  Drawn dive = wrong_dive(11);
  const auto options = options_of(dive);
  // The heading's own bias is in the yaw: the drawn one is known from the readings.
  double bias = 0;
  int headings = 0;
  for (const auto& reading : dive.dive.readings)
    if (reading.quantity == Quantity::heading)
      bias += reading.value.x() - dive.truth[static_cast<std::size_t>(reading.time_s)].heading,
          ++headings;
  bias /= headings;
  const auto found = calibrate(dive.dive, options, both, {});
  EXPECT_TRUE(found.converged);
  for (const auto& finding : found.findings) EXPECT_EQ(finding.verdict, Verdict::told);
  EXPECT_LT(found.findings[0].sigma, 0.3 * degree);
  EXPECT_LT(std::abs(found.findings[0].value - (yaw - bias)), 3 * found.findings[0].sigma);
  EXPECT_LT(std::abs(found.findings[1].value - scale), 3 * found.findings[1].sigma);
}

TEST(Calibrate, WithoutFixesWhatOnlyTheyTellStaysAsTheRigHasIt) {
  Drawn dive = wrong_dive(12);
  std::erase_if(dive.dive.readings,
                [](const auto& reading) { return reading.quantity == Quantity::fix; });
  const auto found = calibrate(dive.dive, options_of(dive), parameters_of(dive.dive), {}, false);
  EXPECT_TRUE(found.converged);
  for (const auto& finding : found.findings) {
    const auto unknown = finding.parameter.unknown;
    if (unknown == Unknown::pitch) continue;
    EXPECT_EQ(finding.verdict, Verdict::not_told) << name_of(unknown);
    EXPECT_EQ(finding.value, 0) << name_of(unknown);
    EXPECT_EQ(finding.sigma, finding.parameter.prior_sigma) << name_of(unknown);
    EXPECT_NE(finding.why.find("no fix"), std::string::npos) << finding.why;
  }
}

TEST(Calibrate, FixesAtOneEndTellNoYaw) {
  Drawn dive = wrong_dive(12);
  double surfaced = 0;
  for (const auto& reading : dive.dive.readings) surfaced = std::max(surfaced, reading.time_s);
  std::erase_if(dive.dive.readings, [&](const auto& reading) {
    return reading.quantity == Quantity::fix && reading.time_s < surfaced - 3;
  });
  const auto found = calibrate(dive.dive, options_of(dive), {both[0]}, {}, false);
  EXPECT_EQ(found.findings[0].verdict, Verdict::not_told);
  EXPECT_NE(found.findings[0].why.find("between two fixes"), std::string::npos);
}

TEST(Calibrate, ADiveWithoutDepthAndHeightsTellsNoPitch) {
  Drawn dive = wrong_dive(12);
  for (auto& reading : dive.dive.readings)
    if (reading.quantity == Quantity::fix) reading.value.z() = std::nan("");
  std::erase_if(dive.dive.readings,
                [](const auto& reading) { return reading.quantity == Quantity::depth; });
  const auto found = calibrate(dive.dive, options_of(dive),
                               {{0, Unknown::pitch, usual_prior(Unknown::pitch)}}, {}, false);
  EXPECT_EQ(found.findings[0].verdict, Verdict::not_told);
  EXPECT_NE(found.findings[0].why.find("no depth"), std::string::npos);
}

TEST(Calibrate, AValueThatNobodyCouldExpectIsNotTold) {
  Calibration result;
  const double prior = usual_prior(Unknown::yaw);
  result.findings.push_back({both[0], 2.9 * prior, 0.01 * prior, Verdict::told, {}, -1});
  result.findings.push_back({both[0], -3.1 * prior, 0.01 * prior, Verdict::told, {}, -1});
  result.correlation = Eigen::MatrixXd::Identity(2, 2);
  result.converged = true;
  judge(result);
  EXPECT_EQ(result.findings[0].verdict, Verdict::told);
  EXPECT_EQ(result.findings[1].verdict, Verdict::not_told);
  EXPECT_NE(result.findings[1].why.find("3 sigmas"), std::string::npos);
}

TEST(Calibrate, SaysWhichTwoParametersHideEachOther) {
  Drawn dive = wrong_dive(13);
  auto parameters = both;
  parameters.push_back({1, Unknown::deviation_constant, usual_prior(Unknown::deviation_constant)});
  const auto found = calibrate(dive.dive, options_of(dive), parameters, {}, false);
  EXPECT_EQ(found.findings[0].confused_with, 2);
  EXPECT_EQ(found.findings[2].confused_with, 0);
  EXPECT_NE(found.findings[0].verdict, Verdict::told);
  EXPECT_EQ(found.findings[1].verdict, Verdict::told);
  EXPECT_GT(std::abs(found.correlation(0, 2)), 0.99);
}

TEST(Calibrate, ASearchThatDoesNotSettleTellsNothing) {
  Calibration result;
  result.findings.push_back({both[0], yaw, 0.01 * yaw, Verdict::told, {}, -1});
  result.correlation = Eigen::MatrixXd::Identity(1, 1);
  result.converged = true;
  judge(result);
  EXPECT_EQ(result.findings[0].verdict, Verdict::told);
  result.converged = false;
  judge(result);
  EXPECT_EQ(result.findings[0].verdict, Verdict::not_told);
  EXPECT_EQ(result.findings[0].why, "the search did not settle");
}

TEST(Parameters, LeaveTheConstantOfACompassOutBesideADvl) {
  const auto dvl = parameters_of(drawn(Voyage(30), 1).dive);
  const auto log = parameters_of(drawn(Voyage(30), 1, 0.3).dive);
  const auto constant = [](const auto& all) {
    return std::ranges::count(all, Unknown::deviation_constant, &Parameter::unknown);
  };
  EXPECT_EQ(dvl.size(), 10U);  // six of the DVL, sine, cosine, latency of the compass, of the depth
  EXPECT_EQ(log.size(), 7U);   // scale, latency of the log, four of the compass, of the depth
  EXPECT_EQ(constant(dvl), 0);
  EXPECT_EQ(constant(log), 1);
}

}  // namespace
}  // namespace drydock::calibration
