#include <gtest/gtest.h>

#include "drivers/monitor/monitor_loop.hpp"

namespace drydock::monitor {
namespace {

DeviceView imu_at(double rate_hz) {
  DeviceView imu;
  imu.name = "imu";
  imu.streaming = true;
  imu.nominal_rate_hz = 20;
  imu.rate_hz = rate_hz;
  imu.jitter_s = 0.02;
  imu.values = {{"specific_force", "", ""}};
  return imu;
}

/// Exit code of `monitor --once`, whose views have these rates, one after the other.
int exit_of_once(std::vector<double> rates, double duration_s) {
  MonitorOptions options;
  options.once = true;
  options.duration_s = duration_s;
  std::size_t seen = 0;
  const auto views = [&] { return std::vector{imu_at(rates[std::min(seen++, rates.size() - 1)])}; };
  MonitorLoop loop(options, "rig", views, {});
  return loop.run([] {}, [] {});
}

TEST(MonitorOnce, OnePauseOfABusyHostIsNoSlowDevice) {
  EXPECT_EQ(exit_of_once({12, 15, 19.9}, 10), 0);
}

TEST(MonitorOnce, ADeviceThatStaysSlowIsWrongAtTheEnd) { EXPECT_EQ(exit_of_once({12}, 0.5), 1); }

}  // namespace
}  // namespace drydock::monitor
