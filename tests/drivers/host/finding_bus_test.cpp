#include <gmock/gmock.h>
#include <poll.h>

#include <chrono>

#include "drivers/bus/subscriber.hpp"
#include "drivers/host/rig_publisher.hpp"
#include "tests/own_domain.hpp"

namespace drydock::host {
namespace finding_bus_test {

/// Keeps the statuses that come from the bus.
struct Heard final : bus::Receiver {
  using bus::Receiver::receive;
  void receive(const bus::Measurement&) override {}
  void receive(const bus::DeviceStatus& status) override { statuses.push_back(status); }
  std::vector<bus::DeviceStatus> statuses;
};

/// Calls `publish` again and again until a status comes, or patience is over: a reader that
/// DDS has not found yet hears nothing.
template <class Publish>
std::vector<bus::DeviceStatus> heard_after(bus::Subscriber& subscriber, Publish publish) {
  Heard heard;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds{30};
  while (heard.statuses.empty() && std::chrono::steady_clock::now() < end) {
    publish();
    pollfd readable{subscriber.fd(), POLLIN, 0};
    ::poll(&readable, 1, 50);
    subscriber.take(heard);
  }
  return heard.statuses;
}

TEST(FindingOnTheBus, ComesAtOnceIsToldAgainWithTheHealthAndIsOkWhenItIsOver) {
  const bus::Participant participant(test::own_domain(), "lo");
  std::vector<bus::Device> devices(1);
  devices[0].name = "dvl";
  devices[0].kind = bus::Kind::dvl;
  RigPublisher publisher(participant, devices);
  bus::SubscriberOptions wanted;
  wanted.diagnostics = true;
  bus::Subscriber subscriber(participant, devices, wanted);

  diagnosis::Finding finding;
  finding.cause = diagnosis::Cause::damaged;
  finding.since = finding.found = measurement::Stamp{std::chrono::seconds{100}};
  const auto begun = heard_after(subscriber, [&] { publisher.on_finding(finding); });
  ASSERT_FALSE(begun.empty());
  EXPECT_EQ(begun.back().name, "dvl/damaged");
  EXPECT_EQ(begun.back().level, bus::Level::warn);

  const HealthReport health([] { return HealthReport::Statuses(1); });
  const auto again = heard_after(subscriber, [&] { publisher.on_health(health, finding.found); });
  EXPECT_THAT(again, testing::Contains(testing::Field(&bus::DeviceStatus::name, "dvl/damaged")));

  finding.until = finding.found + std::chrono::seconds{3};
  const auto over = heard_after(subscriber, [&] { publisher.on_finding(finding); });
  ASSERT_FALSE(over.empty());
  EXPECT_EQ(over.back().level, bus::Level::ok);
  const auto after = heard_after(subscriber, [&] { publisher.on_health(health, *finding.until); });
  EXPECT_THAT(after, testing::Each(testing::Field(&bus::DeviceStatus::name, testing::StrEq(""))));
}

}  // namespace finding_bus_test
}  // namespace drydock::host
