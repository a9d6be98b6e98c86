#include "drivers/host/integrity_status.hpp"

#include <gmock/gmock.h>

#include <numbers>

namespace drydock::host {
namespace integrity_status_test {

using testing::Contains;
using testing::Pair;

/// A leveling estimate at so many seconds.
Estimate estimate_at(double seconds, bool valid) {
  Estimate estimate;
  estimate.attitude.valid_at = measurement::Stamp{} + measurement::from_seconds(seconds);
  estimate.integrity = {.valid = valid,
                        .roll_bound_rad = std::numbers::pi / 180,
                        .pitch_bound_rad = std::numbers::pi / 90,
                        .heading_bound_rad = {},
                        .horizontal_bound_m = 12.5};
  return estimate;
}

TEST(IntegrityStatuses, SayTheBoundsInDegreesAndMetres) {
  IntegrityStatuses statuses({"leveling"});
  const auto status = statuses.take(estimate_at(100, true));
  ASSERT_TRUE(status);
  EXPECT_EQ(status->name, "leveling/integrity");
  EXPECT_EQ(status->level, bus::Level::ok);
  EXPECT_THAT(status->values, Contains(Pair("valid", "true")));
  EXPECT_THAT(status->values, Contains(Pair("roll_bound_deg", "1")));
  EXPECT_THAT(status->values, Contains(Pair("pitch_bound_deg", "2")));
  EXPECT_THAT(status->values, Contains(Pair("horizontal_bound_m", "12.5")));
  EXPECT_THAT(status->values, testing::Not(Contains(Pair("heading_bound_deg", testing::_))));
}

TEST(IntegrityStatuses, OfAnEstimateThatCameWithoutBoundsSayNothing) {
  IntegrityStatuses statuses({"leveling"});
  Estimate heard;
  heard.attitude.valid_at = measurement::Stamp{} + measurement::from_seconds(100);
  EXPECT_FALSE(statuses.take(heard));
}

TEST(IntegrityStatuses, ComeOnceASecondAndAtEachChange) {
  IntegrityStatuses statuses({"leveling"});
  int told = 0;
  for (int i = 0; i < 500; ++i)
    told += statuses.take(estimate_at(100 + 0.01 * i, true)).has_value();
  EXPECT_EQ(told, 5);
  const auto doubt = statuses.take(estimate_at(105.001, false));
  ASSERT_TRUE(doubt);
  EXPECT_EQ(doubt->level, bus::Level::warn);
  EXPECT_FALSE(statuses.take(estimate_at(105.002, false)));
  EXPECT_TRUE(statuses.take(estimate_at(105.003, true)));
}

TEST(IntegrityStatuses, SayOnceASecondThatASilentEstimatorIsNotValid) {
  IntegrityStatuses statuses({"leveling"});
  std::vector<bus::DeviceStatus> told;
  const auto look = [&](double seconds) {
    statuses.look(measurement::Stamp{} + measurement::from_seconds(seconds),
                  [&](const bus::DeviceStatus& status) { told.push_back(status); });
  };
  for (int i = 0; i < 500; ++i) {
    look(100 + 0.01 * i);
    statuses.take(estimate_at(100 + 0.01 * i, true));
  }
  EXPECT_TRUE(told.empty());
  for (int i = 0; i < 300; ++i) look(105 + 0.1 * i);  // its IMU is silent for 30 s
  ASSERT_EQ(told.size(), 30u);                        // from 105.5 s on
  EXPECT_EQ(told.front().name, "leveling/integrity");
  EXPECT_EQ(told.front().level, bus::Level::warn);
  EXPECT_THAT(told.front().values, Contains(Pair("valid", "false")));
  EXPECT_TRUE(statuses.take(estimate_at(135.1, true))) << "the change back";
}

// A log at 0.2 Hz paces a dead reckoning: five seconds are its usual time between two estimates.
TEST(IntegrityStatuses, WaitAsLongAsTheEstimatorsOwnPace) {
  IntegrityStatuses statuses({"slow"});
  int told = 0;
  for (int i = 0; i < 100; ++i) {
    statuses.look(measurement::Stamp{} + measurement::from_seconds(100 + i),
                  [&](const bus::DeviceStatus&) { ++told; });
    if (i % 5 == 0) statuses.take(estimate_at(100 + i, true));
  }
  EXPECT_EQ(told, 5);  // before its pace is known
}

}  // namespace integrity_status_test
}  // namespace drydock::host
