#include "hil/validity/deadlines.hpp"

#include <gtest/gtest.h>

#include "hil/bench/run.hpp"
#include "hil/validity/run/sent_and_heard.hpp"
#include "rig_config/load.hpp"

namespace deadlines_test {

using namespace drydock;
using namespace std::chrono_literals;
using measurement::Stamp;
using validity::Deadlines;
using validity::Floor;

const Stamp begin = measurement::stamp_from_ns(1'000'000'000'000);

/// A device of 10 Hz. Sample k is taken at 100 k ms.
class Device {
 public:
  void sends(int sample) {
    listener_.note("dvl", {at(sample), at(sample), at(sample), at(sample)}, at(sample));
  }
  void answers(int sample, std::chrono::nanoseconds after) {
    measurement::BottomVelocity velocity;
    velocity.origin.valid_at = at(sample);
    listener_.note(velocity, at(sample) + after);
  }
  void sends_and_answers(int first, int last, std::chrono::nanoseconds after) {
    for (int k = first; k <= last; ++k) {
      sends(k);
      answers(k, after);
    }
  }
  Deadlines judged(const Floor& floor, std::chrono::nanoseconds run) const {
    return validity::deadlines_of("dvl", 10, listener_.sampled_at("dvl"), listener_.figures(),
                                  floor, {begin, begin + run});
  }

 private:
  static Stamp at(int sample) { return begin + sample * 100ms; }

  validity::Listener listener_{{"dvl"}};
};

TEST(Deadlines, AnAnswerWithinThePeriodKeepsItsDeadline) {
  Device device;
  device.sends_and_answers(0, 99, 40ms);
  const Deadlines d = device.judged({}, 10s);
  EXPECT_TRUE(d.kept());
  EXPECT_EQ(d.samples, 100U);
  EXPECT_DOUBLE_EQ(d.response.largest_us, 40e3);
  EXPECT_DOUBLE_EQ(d.least_margin_us, 60e3);
  EXPECT_DOUBLE_EQ(d.first_s, 0.04);
}

TEST(Deadlines, AnAnswerAfterThePeriodIsMissed) {
  Device device;
  device.sends_and_answers(0, 49, 40ms);
  device.sends(50);
  device.answers(50, 130ms);
  device.sends_and_answers(51, 99, 40ms);
  const Deadlines d = device.judged({}, 10s);
  EXPECT_EQ(d.missed, 1U);
  EXPECT_EQ(d.lost, 0U);
  EXPECT_DOUBLE_EQ(d.least_margin_us, -30e3);
  EXPECT_FALSE(d.kept());
}

TEST(Deadlines, WhatTheMachineDidToABareTimerExcusesTheSameSecondAlone) {
  Device device;
  device.sends_and_answers(0, 49, 40ms);
  device.sends(50);
  device.answers(50, 130ms);
  device.sends_and_answers(51, 99, 40ms);
  Floor same, another;
  same.add_timer(begin + 5100ms, 20e3);
  same.add_link(begin + 5900ms, 15e3);
  another.add_timer(begin + 7100ms, 50e3);
  EXPECT_EQ(device.judged(same, 10s).missed, 0U);
  EXPECT_EQ(device.judged(another, 10s).missed, 1U);
}

TEST(Deadlines, ALongStallCountsForEverySecondItLasted) {
  Floor floor;
  floor.add_timer(begin + 9500ms, 2.4e6);
  EXPECT_DOUBLE_EQ(floor.worst_us(begin + 7100ms, begin + 7200ms), 2.4e6);
  EXPECT_DOUBLE_EQ(floor.worst_us(begin + 6100ms, begin + 6900ms), 0);
}

TEST(Deadlines, ASampleThatNothingCameOfIsLost) {
  Device device;
  device.sends_and_answers(0, 49, 40ms);
  device.sends(50);
  device.sends_and_answers(51, 99, 40ms);
  const Deadlines d = device.judged({}, 10s);
  EXPECT_EQ(d.lost, 1U);
  EXPECT_EQ(d.missed, 0U);
  EXPECT_FALSE(d.kept());
}

TEST(Deadlines, ASampleThatAStallLongerThanItsPeriodTookIsTheMachines) {
  Device device;
  device.sends_and_answers(0, 49, 40ms);
  device.sends(50);
  device.sends_and_answers(51, 99, 40ms);
  Floor floor;
  floor.add_timer(begin + 5200ms, 150e3);
  const Deadlines d = device.judged(floor, 10s);
  EXPECT_EQ(d.lost, 0U);
  EXPECT_EQ(d.stalled, 1U);
}

TEST(Deadlines, ADeviceThatFallsSilentLosesAllThatWasDueBeforeTheEnd) {
  Device device;
  device.sends_and_answers(0, 49, 40ms);
  for (int k = 50; k <= 99; ++k) device.sends(k);
  const Deadlines d = device.judged({}, 10s);
  EXPECT_EQ(d.lost, 49U) << "the hundredth was due as the run ended";
}

TEST(Deadlines, ADeviceThatSendsLessThanItsRateDoesNotHoldIt) {
  Device device;
  device.sends_and_answers(0, 49, 40ms);
  device.sends_and_answers(53, 99, 40ms);
  const Deadlines d = device.judged({}, 10s);
  EXPECT_EQ(d.lost, 0U);
  EXPECT_DOUBLE_EQ(d.sent_hz, 9.7);
  EXPECT_FALSE(d.rate_held());
  EXPECT_FALSE(d.kept());
}

TEST(Deadlines, ADeviceOfWhichNothingCameKeepsNone) {
  Device device;
  device.sends(0);
  EXPECT_FALSE(device.judged({}, 10s).kept());
}

TEST(Deadlines, TheLinesAndBusesOfFortyDevicesLeaveEveryDeadlineAMargin) {
  const auto rig = rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/forty.toml").value();
  std::vector<std::string> names;
  for (const auto& device : rig.devices) names.push_back(device.name);
  validity::Listener listener(names);
  bench::RunOptions options;
  options.duration_s = 5;
  options.lockstep = options.quiet = true;
  validity::SentAndHeard sent_and_heard(listener);
  options.followers = {&sent_and_heard};
  testing::internal::CaptureStdout();
  bench::run_lockstep(rig, options);
  testing::internal::GetCapturedStdout();

  const Stamp start = measurement::stamp_from_ns(rig.start_utc_ns);
  for (const auto& device : rig.devices) {
    auto figures = listener.figures();
    std::erase_if(figures, [&](const auto& of) { return of.device != device.name; });
    const Deadlines d =
        validity::deadlines_of(device.name, device.rate_hz, listener.sampled_at(device.name),
                               figures, {}, {start, start + 5s});
    EXPECT_TRUE(d.kept()) << d.device << ": " << d.missed << " missed, " << d.lost << " lost, "
                          << d.sent_hz << " Hz";
    EXPECT_GT(d.least_margin_us, 0.2 * 1e6 / device.rate_hz) << d.device;
  }
}

}  // namespace deadlines_test
