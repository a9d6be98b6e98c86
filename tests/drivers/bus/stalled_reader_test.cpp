#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>

#include "tests/drivers/bus/bus_fixture.hpp"
#include "tests/drivers/bus/child_process.hpp"

namespace drydock::bus::test {
namespace {

using namespace measurement;
using std::chrono::microseconds;

Measurement numbered(double number) {
  auto sample = only_origin<ImuSample>(imu);
  sample.specific_force.x() = number;
  return sample;
}

double number_of(const Measurement& m) { return std::get<ImuSample>(m).specific_force.x(); }

/// Writes as fast as possible. Returns the median time of one write.
microseconds median_write(Publisher& publisher, int count) {
  std::vector<microseconds> times;
  for (int i = 0; i < count; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    publisher.publish(numbered(i));
    times.push_back(
        std::chrono::duration_cast<microseconds>(std::chrono::steady_clock::now() - begin));
  }
  std::ranges::nth_element(times, times.begin() + count / 2);
  return times[static_cast<std::size_t>(count / 2)];
}

TopicCounters counters_of(const Publisher& publisher, std::string_view topic) {
  for (const auto& counters : publisher.counters()) {
    if (counters.topic == topic) return counters;
  }
  return {};
}

std::string child_domain() { return std::to_string(test_domain()); }

TEST(BusReaders, SubscriberThatNeverTakesDoesNotSlowTheWriter) {
  const Participant participant(test_domain());
  Publisher publisher(participant, all_devices());
  Subscriber subscriber(participant, all_devices());
  ASSERT_TRUE(eventually([&] { return publisher.matched_readers() == 8; }));
  EXPECT_LT(median_write(publisher, 5000), microseconds(1000));
  EXPECT_EQ(counters_of(publisher, "rt/imu/data").written, 5000u);
  const auto kept = take(subscriber, 1);  // the newest samples of a bounded queue, in order
  ASSERT_EQ(kept.size(), 2000u);
  EXPECT_EQ(number_of(kept.front()), 3000);
  EXPECT_EQ(number_of(kept.back()), 4999);
}

TEST(BusReaders, StoppedProcessDoesNotSlowTheWriterAndTheCountersCoverWhatItLost) {
  const ChildProcess child({"--child", "subscribe", child_domain()});
  ASSERT_EQ(child.read_line(), "subscribed");
  const Participant participant(test_domain());
  Publisher publisher(participant, all_devices());
  ASSERT_TRUE(eventually([&] { return publisher.matched_readers() == 8; }));
  ASSERT_EQ(child.read_line(), "matched");
  child.signal(SIGSTOP);
  EXPECT_LT(median_write(publisher, 2000), microseconds(1000));
  const auto counters = counters_of(publisher, "rt/imu/data");
  EXPECT_EQ(counters.written, 2000u);
  EXPECT_GT(counters.overrun, 0u);
  EXPECT_EQ(counters.failed, 0u);
  child.signal(SIGCONT);
  publisher.publish(numbered(end_of_numbers));
  const auto taken = std::stoul("0" + child.read_line());
  RecordProperty("taken", static_cast<int>(taken));
  RecordProperty("overrun", static_cast<int>(counters.overrun));
  EXPECT_GE(taken + counters.overrun, counters.written);
}

TEST(BusReaders, HealthyReaderBesideAStoppedOneGetsEverySampleInOrder) {
  const ChildProcess child({"--child", "subscribe", child_domain()});
  ASSERT_EQ(child.read_line(), "subscribed");
  const Participant participant(test_domain());
  Publisher publisher(participant, all_devices());
  Subscriber healthy(participant, all_devices());
  ASSERT_TRUE(eventually([&] { return publisher.matched_readers() == 16; }));
  ASSERT_EQ(child.read_line(), "matched");
  child.signal(SIGSTOP);
  median_write(publisher, 1500);
  const auto taken = take(healthy, 1500);
  ASSERT_EQ(taken.size(), 1500u);
  for (std::size_t i = 0; i < taken.size(); ++i) {
    ASSERT_EQ(number_of(taken[i]), static_cast<double>(i));
  }
}

TEST(BusReaders, LateSubscriberGetsWhatIsPublishedFromThenOn) {
  const Participant participant(test_domain());
  Publisher publisher(participant, all_devices());
  publisher.publish(numbered(1));
  Subscriber subscriber(participant, all_devices());
  ASSERT_TRUE(eventually([&] { return subscriber.matched_writers() == 8; }));
  publisher.publish(numbered(2));
  const auto taken = take(subscriber, 1);
  ASSERT_EQ(taken.size(), 1u);
  EXPECT_EQ(number_of(taken[0]), 2);
}

TEST(BusReaders, AnotherProcessGetsEverySampleInOrder) {
  const Participant participant(test_domain());
  Subscriber subscriber(participant, all_devices());
  const ChildProcess child({"--child", "publish", child_domain(), "1000"});
  ASSERT_EQ(child.read_line(), "matched");
  ASSERT_TRUE(eventually([&] { return subscriber.matched_writers() == 8; }));
  child.signal(SIGUSR1);
  const auto taken = take(subscriber, 1000);
  ASSERT_EQ(taken.size(), 1000u);
  for (std::size_t i = 0; i < taken.size(); ++i) {
    ASSERT_EQ(number_of(taken[i]), static_cast<double>(i));
  }
  EXPECT_EQ(origin_of(taken[0]).received_at, origin(imu).received_at);
  EXPECT_EQ(origin_of(taken[0]).provenance, Provenance::replayed);
}

}  // namespace
}  // namespace drydock::bus::test
