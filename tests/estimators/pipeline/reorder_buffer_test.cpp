#include "estimators/pipeline/reorder_buffer.hpp"

#include <gtest/gtest.h>

#include "tests/estimators/pipeline/support.hpp"

namespace drydock::pipeline {
namespace {

using test::at_ms;
using test::imu;
using test::water_speed;

TEST(ReorderBuffer, GivesTheOldestFirst) {
  ReorderBuffer buffer{8};
  for (const int ms : {30, 10, 40, 20}) buffer.push(imu(ms));
  for (const int ms : {10, 20, 30, 40}) {
    EXPECT_EQ(buffer.oldest(), at_ms(ms));
    EXPECT_EQ(origin_of(buffer.pop()).valid_at, at_ms(ms));
  }
  EXPECT_TRUE(buffer.empty());
}

TEST(ReorderBuffer, OfOneInstantTheImuComesFirstThenTheLowerDevice) {
  ReorderBuffer buffer{8};
  buffer.push(water_speed(10));
  buffer.push(imu(10, 0, 9));
  buffer.push(imu(10, 0, 2));
  EXPECT_EQ(origin_of(buffer.pop()).device, 2);
  EXPECT_EQ(origin_of(buffer.pop()).device, 9);
  EXPECT_TRUE(std::holds_alternative<measurement::WaterSpeed>(buffer.pop()));
}

TEST(ReorderBuffer, TwinsOfOneDeviceKeepTheirOrderOfArrival) {
  ReorderBuffer buffer{8};
  for (const double mps : {1., 2., 3.}) buffer.push(water_speed(10, mps));
  for (const double mps : {1., 2., 3.}) {
    EXPECT_EQ(std::get<measurement::WaterSpeed>(buffer.pop()).longitudinal_mps, mps);
  }
}

TEST(ReorderBuffer, IsFullAtItsCapacity) {
  ReorderBuffer buffer{2};
  buffer.push(imu(0));
  EXPECT_FALSE(buffer.full());
  buffer.push(imu(1));
  EXPECT_TRUE(buffer.full());
}

}  // namespace
}  // namespace drydock::pipeline
