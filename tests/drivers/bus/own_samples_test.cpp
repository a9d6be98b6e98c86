#include <gtest/gtest.h>

#include "tests/drivers/bus/bus_fixture.hpp"

/// Two rigs of one machine in one domain, with devices of the same names.
namespace drydock::bus::test {
namespace own_samples_test {

using measurement::ImuSample;

ImuSample sample(double force) {
  auto imu = only_origin<ImuSample>(Index::imu);
  imu.specific_force = {force, 0, -9.8};
  return imu;
}

TEST(OwnSamples, AreAllThatABenchTakesWhereAnotherOneHasTheSameNames) {
  const Participant ours(test_domain()), theirs(test_domain());
  Publisher publisher(ours, all_devices()), other(theirs, all_devices());
  Subscriber subscriber(ours, all_devices(),
                        {.estimators = {}, .diagnostics = false, .own_only = true});
  Subscriber witness(ours, all_devices());
  ASSERT_TRUE(eventually([&] {
    other.publish(sample(1));
    EXPECT_EQ(subscriber.take_measurements([](const Measurement&) {}), 0u);
    return witness.take_measurements([](const Measurement&) {}) > 0 && subscriber.foreign() > 0;
  })) << "the other bench is heard on the bus";
  publisher.publish(sample(2));
  const auto taken = take(subscriber, 1);
  ASSERT_EQ(taken.size(), 1u);
  EXPECT_EQ(std::get<ImuSample>(taken[0]).specific_force.x(), 2);
}

}  // namespace own_samples_test
}  // namespace drydock::bus::test
