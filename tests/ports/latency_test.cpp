// How late the kernel and our links are, in a machine whose time counts instructions: 2 ns each,
// idle time is passed over. So the figures repeat on a busy host, and a test may judge them.
// Only what stays inside the machine is on that time: timers and CAN, not the serial ports.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/asio/steady_timer.hpp>
#include <cstdio>
#include <vector>

#include "drivers/link/can/can_interface.hpp"
#include "tests/ports/can.hpp"
#include "tests/ports/driver.hpp"

namespace drydock::ports {
namespace {

using namespace std::chrono_literals;
namespace asio = boost::asio;
using link::testing::open_bus;

double us(std::chrono::nanoseconds time) { return static_cast<double>(time.count()) / 1e3; }

struct Percentiles {
  double p50 = 0, p99 = 0, max = 0;  ///< us
};

Percentiles percentiles(std::vector<double> values) {
  std::ranges::sort(values);
  const auto at = [&](double part) {
    return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
  };
  return {at(0.5), at(0.99), values.back()};
}

void print(const char* what, const Percentiles& found) {
  std::printf("%-28s p50 %7.1f us  p99 %7.1f us  max %7.1f us\n", what, found.p50, found.p99,
              found.max);
}

constexpr int rounds = 200;

/// How late a timer of 10 ms wakes the loop.
std::vector<double> timer_lateness() {
  asio::io_context io{1};
  asio::steady_timer timer(io);
  std::vector<double> late;
  for (int i = 0; i < rounds; ++i) {
    timer.expires_after(10ms);
    timer.async_wait([&](const auto&) {
      late.push_back(us(std::chrono::steady_clock::now() - timer.expiry()));
    });
    io.run();
    io.restart();
  }
  return late;
}

/// From before the write of a frame to the stamp of its reader on the other end, each 10 ms.
std::vector<double> hops(const std::string& from, const std::string& to) {
  asio::io_context io{1};
  const auto writer = open_bus(io, from, link::Side::device);
  const auto reader = open_bus(io, to, link::Side::driver);
  asio::steady_timer timer(io);
  std::vector<double> took;
  wire::CanFrame frame;
  frame.id = 0x123;
  frame.size = 8;
  for (int i = 0; i < rounds; ++i) {
    timer.expires_after(10ms);
    timer.async_wait([](const auto&) {});
    io.run();
    io.restart();
    const auto before = link::now();
    const auto written = link::testing::start(io, writer->write(frame));
    const auto read = link::testing::run(io, reader->read());
    if (read) took.push_back(us(link::now() - before));
    link::testing::run_until(io, [&] { return written->outcome.has_value(); });
  }
  return took;
}

/// Jitter is bounded too: the slowest of a hundred is half as late again, at the most.
void expect_repeats(const Percentiles& first, const Percentiles& second) {
  EXPECT_NEAR(first.p50, second.p50, 0.01 * first.p50 + 0.1);
  EXPECT_LT(first.p99, 1.5 * first.p50);
}

class VirtualTime : public ::testing::Test {
 protected:
  void SetUp() override {
    runs_on({"can0", "can1"});
    bring_up("can0", "bitrate 1000000");
    bring_up("can1", "bitrate 1000000");
  }
  void TearDown() override {
    for (const char* name : {"can0", "can1"}) EXPECT_FALSE(link::set_interface_up(name, false));
  }
};

TEST_F(VirtualTime, ABareTimerRepeatsToOnePercent) {
  const auto first = percentiles(timer_lateness()), second = percentiles(timer_lateness());
  print("timer", first);
  EXPECT_LT(first.p99, 50);
  expect_repeats(first, second);
}

TEST_F(VirtualTime, AFrameCrossesTwoControllersInTheSameTimeEachTime) {
  const std::string can0 = "socketcan:can0?bitrate=1000000",
                    can1 = "socketcan:can1?bitrate=1000000";
  const auto first = percentiles(hops(can0, can1)), second = percentiles(hops(can0, can1));
  print("frame over two SJA1000", first);
  EXPECT_LT(first.p99, 300);
  expect_repeats(first, second);
}

}  // namespace
}  // namespace drydock::ports
