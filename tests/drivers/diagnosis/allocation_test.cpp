#include <gtest/gtest.h>

#include "drivers/diagnosis/judge.hpp"
#include "drivers/diagnosis/monitors/bus_monitor.hpp"
#include "drivers/diagnosis/monitors/device_monitor.hpp"
#include "tests/drivers/diagnosis/signs.hpp"
#include "tests/estimators/pipeline/counting_new.hpp"

namespace drydock::diagnosis::allocation_test {

using namespace measurement;

/// Counts what begins and ends, and keeps nothing.
struct Count : FindingListener {
  void on_finding(const Finding&) override { ++said; }
  int said = 0;
};

/// A minute that is sound, wild samples, a jump, a value that stands still, silence, and back.
template <class Sample>
Sample sample_at(int i) {
  const double noise = 0.01 * ((i * 7919) % 13 - 6);
  const double wild = i % 97 == 0 && i > 400 && i < 800 ? 1e3 : 0;
  const double value = i > 900 && i < 1100 ? 1 : 1 + noise + wild + (i > 1300 ? 5 : 0);
  Sample sample;
  sample.origin.received_at = sample.origin.valid_at = at_s(0.2 * i + (i > 1500 ? 60 : 0));
  if constexpr (std::is_same_v<Sample, BottomVelocity>)
    sample.velocity = Eigen::Vector3d{value, noise, -noise};
  if constexpr (std::is_same_v<Sample, WaterSpeed>) sample.longitudinal_mps = value;
  if constexpr (std::is_same_v<Sample, DepthSample>) sample.depth_m = value;
  if constexpr (std::is_same_v<Sample, ActuatorState>) sample.rudder_rad = 0.1 * value;
  if constexpr (std::is_same_v<Sample, AttitudeSample>) sample.heading_rad = 0.1 * value;
  if constexpr (std::is_same_v<Sample, ImuSample>) {
    sample.angular_rate = {noise, -noise, 0.1 * value};
    sample.specific_force = {noise, 2 * noise, -9.8};
  }
  if constexpr (std::is_same_v<Sample, GnssFix>) {
    sample.position = Geodetic{0.6 + 1e-7 * value, 2};
    sample.velocity_ned = Eigen::Vector3d{value, noise, 0};
  }
  return sample;
}

template <Kind kind, class Type>
struct Case {
  using Sample = Type;
  static constexpr Kind of = kind;
};
template <class Case>
struct Monitored : testing::Test {};
using Samples = testing::Types<Case<Kind::dvl, BottomVelocity>, Case<Kind::emlog, WaterSpeed>,
                               Case<Kind::depth, DepthSample>, Case<Kind::actuator, ActuatorState>,
                               Case<Kind::attitude, AttitudeSample>, Case<Kind::imu, ImuSample>,
                               Case<Kind::gnss, GnssFix>>;
TYPED_TEST_SUITE(Monitored, Samples);

TYPED_TEST(Monitored, AllocatesNothingASampleWhateverIsWrong) {
  Count count;
  Judge judge(1, count);
  DeviceMonitor monitor({.kind = TypeParam::of, .nominal_rate_hz = 5}, judge);
  device::Health health;
  health.state = device::State::streaming;
  const std::size_t before = pipeline::test::allocations();
  for (int i = 0; i < 2000; ++i) {
    const auto sample = sample_at<typename TypeParam::Sample>(i);
    monitor.take(Measurement{sample});
    monitor.look(health, sample.origin.received_at);
    judge.settle(sample.origin.received_at);
  }
  EXPECT_GT(count.said, 0) << "the faults were found";
  EXPECT_EQ(pipeline::test::allocations(), before);
}

TEST(BusMonitor, AllocatesNothingAFrameEvenOfABusThatBabbles) {
  Count count;
  Judge judge(2, count);
  const std::vector<Expected> nodes{{.device = 0, .nominal_rate_hz = 10, .address = 1},
                                    {.device = 1, .nominal_rate_hz = 10, .address = 2}};
  BusMonitor monitor(nodes, judge);
  const std::size_t before = pipeline::test::allocations();
  for (int i = 0; i < 40'000; ++i) {
    wire::CanFrame frame;
    frame.id =
        i < 20'000 ? 0x181U + static_cast<unsigned>(i % 2) : static_cast<unsigned>(i) & 0x7ff;
    frame.size = 8;
    monitor.take(frame, at_s(0.005 * i));
    if (i % 50 != 0) continue;
    monitor.look(at_s(0.005 * i));
    judge.settle(at_s(0.005 * i));
  }
  EXPECT_GT(count.said, 0) << "the babble was found";
  EXPECT_EQ(pipeline::test::allocations(), before);
}

}  // namespace drydock::diagnosis::allocation_test
