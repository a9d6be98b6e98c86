// Filters on a long voyage: nothing measures the heading, so a constant bias of the vertical gyro
// turns north away, and with it the Earth's rate that the filter expects.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "estimators/leveling/any_leveling_filter.hpp"
#include "tests/estimators/leveling/s_path.hpp"

namespace drydock::leveling {
namespace hours_test {
namespace {

using test::degree;
using test::dt;

TEST(LevelingForHours, ADriftOfTheHeadingOpensTheEarthsRateAsAnUnknownHeadingDoes) {
  // sigma = 1 deg/h for 40 h in 8 steps, as if the heading were forgotten by 40 degrees at once.
  EarthRate drifting{test::latitude}, forgotten{test::latitude};
  double opened = 0;
  for (int i = 0; i < 8; ++i) opened += drifting.drift(degree / 3600, 5 * 3600);
  forgotten.forget_heading(40 * degree);
  EXPECT_NEAR(drifting.variance(), forgotten.variance(), 1e-6 * forgotten.variance());
  EXPECT_NEAR(opened, forgotten.variance(), 1e-6 * forgotten.variance());
  EXPECT_NEAR(drifting.ned().x(), forgotten.ned().x(), 1e-6 * forgotten.ned().x());
}

TEST(LevelingForHours, TheErrorOfTheThirdHourIsAsLargeAsItsCovarianceSays) {
  constexpr int runs = 3;
  constexpr double hour_s = 3600;
  auto options = options_for(FilterKind::augmented);
  options.latitude_rad = test::latitude;
  double nees = 0, worst_rad = 0;
  for (unsigned run = 0; run < runs; ++run) {
    test::SPath path;
    path.amplitude = 180 * degree;  // to all points of the compass
    path.period = 150;
    test::Table1Sensors sensors{200 + run};
    sensors.draw_biases();
    AugmentedLevelingFilter filter{options};
    const auto first = sensors(path.at(0));
    filter.start(first.specific_force, first.angular_rate, first.speed);
    const auto samples = static_cast<long>(3 * hour_s / dt);
    for (long k = 0; k < samples; ++k) {
      const auto r = sensors(path.at(static_cast<double>(k) * dt));
      filter.predict(r.specific_force, r.angular_rate, dt);
      filter.update_nonholonomic(dt);
      if (k % 50 == 0) filter.update_moving(r.speed);
      if (k < samples * 2 / 3) continue;
      const Eigen::Vector2d error{filter.roll(), filter.pitch()};
      nees += error.dot(filter.roll_pitch_covariance().inverse() * error) / 2;
      worst_rad = std::max(worst_rad, error.norm());
    }
  }
  nees /= runs * hour_s / dt;
  RecordProperty("nees", std::to_string(nees));
  EXPECT_GT(nees, 0.3);
  EXPECT_LT(nees, 1.5);
  EXPECT_LT(worst_rad, 0.15 * degree);
}

}  // namespace
}  // namespace hours_test
}  // namespace drydock::leveling
