#include "drivers/host/told_status.hpp"

#include <gmock/gmock.h>

#include "tests/drivers/host/bus_statuses.hpp"

namespace drydock::host {
namespace told_status_test {

TEST(ToldStatus, ComesBackFromTheBusAsItWas) {
  const auto status = status_of(Told{"gnss", "CFG-RATE: an epoch each 500 ms"});
  EXPECT_EQ(status.name, "gnss/told");
  EXPECT_EQ(status.level, bus::Level::ok);
  const auto back = told_of(status);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->device, "gnss");
  EXPECT_EQ(back->what, "CFG-RATE: an epoch each 500 ms");
}

TEST(ToldStatus, HealthAndFindingsAreNone) {
  bus::DeviceStatus health;
  health.name = "gnss";
  EXPECT_FALSE(told_of(health));
  health.name = "gnss/silent";
  EXPECT_FALSE(told_of(health));
}

TEST(ToldStatus, IsOnTheBusAtOnceAndAgainWithTheHealth) {
  test::OneDeviceOnTheBus bus("gnss", bus::Kind::gnss);
  const measurement::Stamp now{std::chrono::seconds{100}};
  const auto named = testing::Field(&bus::DeviceStatus::name, "gnss/told");
  const auto text = testing::Field(&bus::DeviceStatus::message, "115200 baud");
  const auto begun = bus.heard_after([&] { bus.publisher.tell({"gnss", "115200 baud"}, now); });
  EXPECT_THAT(begun, testing::Contains(testing::AllOf(named, text)));
  const HealthReport health([] { return HealthReport::Statuses(1); });
  const auto again = bus.heard_after([&] { bus.publisher.on_health(health, now); });
  EXPECT_THAT(again, testing::Contains(testing::AllOf(named, text)));
}

}  // namespace told_status_test
}  // namespace drydock::host
