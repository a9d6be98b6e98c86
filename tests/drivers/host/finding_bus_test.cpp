#include <gmock/gmock.h>

#include "tests/drivers/host/bus_statuses.hpp"

namespace drydock::host {
namespace finding_bus_test {

TEST(FindingOnTheBus, ComesAtOnceIsToldAgainWithTheHealthAndIsOkWhenItIsOver) {
  test::OneDeviceOnTheBus bus("dvl", bus::Kind::dvl);
  diagnosis::Finding finding;
  finding.cause = diagnosis::Cause::damaged;
  finding.since = finding.found = measurement::Stamp{std::chrono::seconds{100}};
  const auto begun = bus.heard_after([&] { bus.publisher.on_finding(finding); });
  ASSERT_FALSE(begun.empty());
  EXPECT_EQ(begun.back().name, "dvl/damaged");
  EXPECT_EQ(begun.back().level, bus::Level::warn);

  const HealthReport health([] { return HealthReport::Statuses(1); });
  const auto again = bus.heard_after([&] { bus.publisher.on_health(health, finding.found); });
  EXPECT_THAT(again, testing::Contains(testing::Field(&bus::DeviceStatus::name, "dvl/damaged")));

  finding.until = finding.found + std::chrono::seconds{3};
  const auto over = bus.heard_after([&] { bus.publisher.on_finding(finding); });
  ASSERT_FALSE(over.empty());
  EXPECT_EQ(over.back().level, bus::Level::ok);
  const auto after = bus.heard_after([&] { bus.publisher.on_health(health, *finding.until); });
  EXPECT_THAT(after, testing::Each(testing::Field(&bus::DeviceStatus::name, testing::StrEq(""))));
}

}  // namespace finding_bus_test
}  // namespace drydock::host
