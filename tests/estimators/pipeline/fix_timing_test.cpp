#include "estimators/pipeline/fix_timing.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/estimators/pipeline/support.hpp"

namespace drydock::pipeline::fix_timing_test {
namespace {

const Eigen::Vector3d velocity{200, 100, -300};
const frame::Position start{0.6, 2.2, 1000};

/// Where a vehicle with this velocity is at a time, told as of a later time.
measurement::GnssFix fix(double true_s, double told_s) {
  measurement::GnssFix fix;
  fix.origin.valid_at = test::at_ms(std::lround(1000 * told_s));
  const auto at = frame::at_ned_offset(start, true_s * velocity);
  fix.position = {at.latitude_rad, at.longitude_rad};
  fix.ellipsoidal_height_m = at.height_m;
  fix.horizontal_accuracy_m = 2;
  return fix;
}

TEST(FixTiming, OfASoundReceiverIsNotLate) {
  FixTiming timing;
  for (int i = 0; i < 600; ++i) timing.add(fix(0.1 * i, 0.1 * i), velocity);
  EXPECT_NEAR(timing.late_s(), 0, 2e-3);  // a straight line over a round Earth
  EXPECT_EQ(timing.variance(), 0);
}

TEST(FixTiming, FindsALatenessAndForgetsItInAMinute) {
  FixTiming timing;
  for (int i = 0; i < 100; ++i) timing.add(fix(0.1 * i, 0.1 * i), velocity);
  timing.add(fix(10, 10.25), velocity);
  EXPECT_NEAR(timing.late_s(), 0.25, 2e-3);
  for (int i = 1; i < 600; ++i) timing.add(fix(10 + 0.1 * i, 10.25 + 0.1 * i), velocity);
  EXPECT_NEAR(timing.late_s(), 0.25 * std::exp(-1), 4e-3);
  timing.add(fix(70.25, 70.25), velocity);
  EXPECT_LT(timing.late_s(), 0) << "it is right again";
}

TEST(FixTiming, TakesTheNoiseOfPositionsForNoLateness) {
  // 2 m within a circle are 1.41 m an axis, over 374 m/s: 3.8 ms, four sigmas are 15 ms.
  FixTiming timing;
  timing.add(fix(0, 0), velocity);
  timing.add(fix(0.1, 0.114), velocity);
  EXPECT_EQ(timing.variance(), 0);
  timing.add(fix(0.2, 0.254), velocity);
  EXPECT_NEAR(timing.variance(), 0.054 * 0.054 - std::pow(4 * std::sqrt(2) / velocity.norm(), 2),
              1e-4);
}

TEST(FixTiming, SaysNothingOfFixesWithoutAHeightOrFarApart) {
  FixTiming timing;
  timing.add(fix(0, 0), velocity);
  auto flat = fix(1, 2);
  flat.ellipsoidal_height_m.reset();
  timing.add(flat, velocity);
  timing.add(fix(1, 9), velocity);
  EXPECT_EQ(timing.late_s(), 0);
}

}  // namespace
}  // namespace drydock::pipeline::fix_timing_test
