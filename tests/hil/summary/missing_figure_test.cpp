// Why an expected figure has no value.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "hil/summary/judge.hpp"
#include "hil/summary/junit.hpp"

namespace drydock::summary::missing_figure_test {
namespace {

using testing::HasSubstr;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// What the verdict on a figure of this estimator says.
std::string measured(const EstimatorSummary& estimator, const std::string& figure) {
  Outcome found;
  found.estimator = estimator;
  rig_config::ExpectConfig expect;
  expect.estimator = "mine";
  expect.figures = {{figure, {0, 2}}};
  const auto verdict = judge(expect, found).at(0);
  EXPECT_FALSE(verdict.passed);
  return verdict.measured;
}

TEST(MissingFigure, OfAProgramThatDidNotStartSaysSo) {
  EstimatorSummary estimator;
  estimator.program.emplace().failure = "cannot start ./mine: No such file or directory at 0.050 s";
  for (const char* figure : {"nees", "roll_rms_deg", "valid_share", "nis"})
    EXPECT_EQ(measured(estimator, figure),
              "none: its program cannot start ./mine: No such file or directory at 0.050 s");
}

TEST(MissingFigure, OfNoEstimateIsNotOneOfNoTruth) {
  EXPECT_EQ(measured({}, "nees"), "none: no estimate");
  EstimatorSummary estimator;
  estimator.estimates = 3;
  EXPECT_EQ(measured(estimator, "nees"), "none: no estimate has a truth to compare with");
}

TEST(MissingFigure, OfEstimatesWithoutACovarianceIsTheirNees) {
  EstimatorSummary estimator;
  estimator.estimates = 3;
  estimator.whole_run = {.nees_mean = nan, .settling_s = 0};
  estimator.navigation = {.heading_rms_deg = nan, .nees_position = nan};
  for (const char* figure : {"nees", "nees_position"})
    EXPECT_THAT(measured(estimator, figure), HasSubstr("none: no estimate with a truth has a cov"));
  EXPECT_EQ(measured(estimator, "heading_rms_deg"), "none: the estimates do not give it");
}

// XML 1.0 knows neither these bytes nor U+FFFE.
TEST(Junit, TakesAnyText) {
  const auto xml = junit_of_failure("rig\xff", "r.toml", "a\x1b[2J \xc3\xa9 \xef\xbf\xbe \xc3(");
  EXPECT_THAT(xml, HasSubstr("classname=\"rig?\""));
  EXPECT_THAT(xml, HasSubstr("message=\"a?[2J \xc3\xa9 ??? ?(\""));
}

TEST(SummaryJson, TakesAnyText) {
  Summary summary;
  summary.rig = "rig\xff";
  summary.notes = {"\xc3("};
  EXPECT_THAT(to_json(summary), HasSubstr("rig\xef\xbf\xbd"));
}

}  // namespace
}  // namespace drydock::summary::missing_figure_test
