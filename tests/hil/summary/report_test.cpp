#include <gmock/gmock.h>

#include "drivers/measurement/units.hpp"
#include "hil/summary/summary.hpp"

namespace drydock::summary {
namespace {

Summary with_estimator() {
  Summary summary;
  summary.estimators.resize(1);
  summary.traces.resize(1);
  summary.navigation.resize(1);
  summary.estimators[0].name = "leveling";
  return summary;
}

TEST(Report, SaysHowManyEstimatesWereValidAndHowFarTheLastCanBeOff) {
  Summary summary = with_estimator();
  summary.estimators[0].valid_share = 0.9934;
  summary.estimators[0].promised = bus::Integrity{.valid = false,
                                                  .roll_bound_rad = 0.8 * units::degree,
                                                  .pitch_bound_rad = 0.5 * units::degree,
                                                  .heading_bound_rad = {},
                                                  .horizontal_bound_m = 12.5};
  const std::string page = to_html(summary);
  EXPECT_THAT(
      page,
      testing::HasSubstr(
          "99.3 % of the estimates valid<td data-label=\"at the end\"><span class=bad>not valid"));
  EXPECT_THAT(page, testing::HasSubstr("<th>roll within<th>pitch within<th>position within"));
  EXPECT_THAT(page, testing::ContainsRegex("within.>0.8°<td [^<]*>0.5°<td [^<]*>12 m"));
}

TEST(Report, PromisesNothingForAnEstimatorThatNeverSpoke) {
  EXPECT_THAT(to_html(with_estimator()),
              testing::Not(testing::HasSubstr("of the estimates valid<td")));
}

}  // namespace
}  // namespace drydock::summary
