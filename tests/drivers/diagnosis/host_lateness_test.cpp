#include "drivers/diagnosis/monitors/host_lateness.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

#include "drivers/diagnosis/monitors/time_monitor.hpp"
#include "tests/drivers/diagnosis/signs.hpp"

namespace drydock::diagnosis::host_lateness_test {

TEST(HostLateness, IsThatOfWhatCameRightBehindALateWakeAndOfASecondPeriodBeforeIt) {
  HostLateness lateness;
  lateness.add(at_s(10), at_s(10.020));
  EXPECT_NEAR(lateness.at(at_s(10.020)).now_s, 0.022, 1e-9);
  EXPECT_NEAR(lateness.at(at_s(10.024)).now_s, 0.026, 1e-9) << "a worker of the kernel had it";
  EXPECT_EQ(lateness.at(at_s(10.026)).now_s, 0);
  EXPECT_EQ(lateness.at(at_s(9.999)).now_s, 0) << "it came before";
}

TEST(HostLateness, OfTheLastSecondsIsTheLargestOne) {
  HostLateness lateness;
  lateness.add(at_s(10), at_s(10.020));
  lateness.add(at_s(12), at_s(12.003));
  EXPECT_NEAR(lateness.at(at_s(14)).lately_s, 0.020, 1e-9);
  EXPECT_EQ(lateness.at(at_s(15.1)).lately_s, 0);
}

TEST(HostLateness, OfWakesOneRightBehindTheOtherIsThatOfAllUpToATenthOfASecond) {
  HostLateness lateness;
  lateness.add(at_s(10), at_s(10.020));
  lateness.add(at_s(10.022), at_s(10.030));
  EXPECT_NEAR(lateness.at(at_s(10.030)).now_s, 0.032, 1e-9);
  for (int i = 0; i < 2000; ++i) {
    const double due = 10.032 + 0.005 * i;
    lateness.add(at_s(due), at_s(due + 0.003));
  }
  EXPECT_LT(lateness.at(at_s(20.030)).now_s, 0.110);
  lateness.add(at_s(21), at_s(21.001));
  EXPECT_NEAR(lateness.at(at_s(21.001)).now_s, 0.003, 1e-9);
}

/// A device that sends evenly, and a computer that wakes late now and then. What it held comes
/// together when it wakes.
struct BusyComputer {
  BusyComputer(measurement::Kind kind, double rate, bool told)
      : monitor({.kind = kind, .nominal_rate_hz = rate}, signs), rate_hz(rate), is_told(told) {}

  void sleep(double due, double woke) {
    awake = woke;
    if (is_told) lateness.add(at_s(due), at_s(woke));
  }
  /// Sends the next message `late_s` after its time.
  void send(double late_s = 0) {
    sent += 1 / rate_hz;
    come(sent + late_s);
  }
  void come(double at) {
    at = std::max(at, awake);
    measurement::Origin origin;
    origin.received_at = origin.valid_at = at_s(at);
    monitor.take(1, origin, false, lateness.at(at_s(at)));
    monitor.look(at_s(at));
    ++messages;
  }
  void for_seconds(double seconds) {
    for (const double end = sent + seconds; sent < end;) send();
  }
  /// Wakes late by up to `most_s`, twice a second.
  void is_busy_for_seconds(double seconds, double most_s) {
    std::uniform_real_distribution<double> at(0, 0.5 - most_s), late(0.003, most_s);
    for (const double end = sent + seconds; sent < end;) {
      const double from = sent, due = from + at(random);
      while (sent + 1 / rate_hz < due) send();
      sleep(due, due + late(random));
      while (sent < from + 0.5) send();
    }
  }

  Signs signs;
  TimeMonitor monitor;
  HostLateness lateness;
  std::mt19937_64 random{7};
  double rate_hz, sent = 0, awake = 0;
  bool is_told;
  int messages = 0;
};

TEST(ABusyComputer, DoesNotAccuseAnInertialUnit) {
  for (const bool told : {false, true}) {
    BusyComputer imu(measurement::Kind::imu, 100, told);
    imu.for_seconds(40);
    imu.is_busy_for_seconds(600, 0.045);
    EXPECT_EQ(imu.signs.all.empty(), told) << imu.signs.all.size();
  }
}

TEST(ABusyComputer, DoesNotAccuseADepthSensor) {
  for (const bool told : {false, true}) {
    BusyComputer depth(measurement::Kind::depth, 10, told);
    depth.for_seconds(40);
    depth.is_busy_for_seconds(600, 0.2);
    EXPECT_EQ(depth.signs.all.empty(), told) << depth.signs.all.size();
  }
}

/// Its kernel hands on bytes late while this program, on the other processor, is in time.
TEST(ABusyComputer, DoesNotAccuseADeviceForWhatItsKernelHeld) {
  for (const double held_s : {0.004, 0.009}) {
    BusyComputer imu(measurement::Kind::imu, 100, true);
    imu.for_seconds(40);
    for (int second = 0; second < 60; ++second) {
      imu.sleep(imu.sent + 0.005, imu.sent + 0.015);
      for (int i = 0; i < 100; ++i) imu.send(i % 10 == 8 ? held_s : 0);
    }
    EXPECT_TRUE(imu.signs.all.empty()) << held_s;
  }
}

/// It holds one message in eight for 60 ms: the intervals scatter by 60 ms sqrt(2 / 8) = 30 ms.
TEST(ABusyComputer, IsNoJitterFromTheStart) {
  for (const bool told : {false, true}) {
    BusyComputer log(measurement::Kind::emlog, 10, told);
    for (int i = 0; i < 400; ++i) {
      if (i % 8 == 0) log.sleep(log.sent + 0.099, log.sent + 0.160);
      log.send();
    }
    EXPECT_EQ(log.signs.has(Sign::irregular), !told);
  }
}

/// Messages until jitter of up to 50 ms is found at 10 Hz.
int messages_to_find(const std::function<void(BusyComputer&)>& before_each) {
  BusyComputer depth(measurement::Kind::depth, 10, true);
  depth.for_seconds(40);
  std::uniform_real_distribution<double> late(0, 0.05);
  const int sound = depth.messages;
  while (!depth.signs.has(Sign::irregular) && depth.messages < sound + 100) {
    before_each(depth);
    depth.send(late(depth.random));
  }
  return depth.messages - sound;
}

TEST(JitterOfADevice, IsFoundAsSoonOnAComputerThatIsLateByLess) {
  const int quiet = messages_to_find([](BusyComputer&) {});
  const int busy = messages_to_find(
      [](BusyComputer& depth) { depth.sleep(depth.sent + 0.070, depth.sent + 0.073); });
  EXPECT_LT(quiet, 10);
  EXPECT_EQ(busy, quiet);
}

TEST(JitterOfADevice, IsFoundWhenTheComputerIsQuietAgain) {
  BusyComputer imu(measurement::Kind::imu, 100, true);
  imu.for_seconds(40);
  imu.sleep(imu.sent + 0.005, imu.sent + 0.045);
  std::uniform_real_distribution<double> late(0, 0.006);
  for (int i = 0; i < 480; ++i) imu.send(late(imu.random));
  EXPECT_FALSE(imu.signs.has(Sign::irregular)) << "it may be the computer's";
  for (int i = 0; i < 100; ++i) imu.send(late(imu.random));
  EXPECT_TRUE(imu.signs.has(Sign::irregular));
}

TEST(LostMessages, AreGapsOnABusyComputerToo) {
  BusyComputer imu(measurement::Kind::imu, 100, true);
  imu.for_seconds(40);
  for (int i = 0; i < 400; ++i) {
    if (i % 50 == 0) imu.sleep(imu.sent + 0.005, imu.sent + 0.035);
    if (i % 10 == 9) imu.sent += 0.01;
    imu.send();
  }
  EXPECT_TRUE(imu.signs.has(Sign::gaps));
  EXPECT_FALSE(imu.signs.has(Sign::irregular));
}

}  // namespace drydock::diagnosis::host_lateness_test
