// The latency timer of an FTDI chip, whose adapter is a program (usb_serial.py): it keeps bytes as
// the chip does. It needs the machine for itself, since it judges milliseconds.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <termios.h>

#include <algorithm>
#include <functional>
#include <set>
#include <sstream>

#include "tests/drivers/link/running.hpp"
#include "tests/ports/driver.hpp"
#include "tests/ports/usb_device.hpp"

namespace drydock::ports {
namespace {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;

constexpr std::size_t lines = 40;

/// Text, and the time of CLOCK_MONOTONIC at which it came.
struct Came {
  std::string text;
  nanoseconds at{};
};

nanoseconds monotonic() { return std::chrono::steady_clock::now().time_since_epoch(); }

/// What became of the lines that the adapter said.
struct Waits {
  double median_ms{};         // under way
  std::set<int> timers_ms{};  // that the chip was told
};

Waits waits_of_lines(UsbDevice& adapter, const std::function<Came()>& read) {
  adapter.order("say " + std::to_string(lines));
  std::vector<double> waits_ms;
  Waits waits;
  for (std::string text; waits_ms.size() < lines;) {
    const Came came = read();
    if (came.text.empty()) {
      ADD_FAILURE() << "only " << waits_ms.size() << " lines came";
      return {};
    }
    text += came.text;
    for (auto end = text.find('\n'); end != text.npos; end = text.find('\n')) {
      std::int64_t had_ns = 0;
      int timer_ms = 0;
      EXPECT_TRUE(std::istringstream(text) >> had_ns >> timer_ms) << text;
      waits_ms.push_back(
          std::chrono::duration<double, std::milli>(came.at - nanoseconds{had_ns}).count());
      waits.timers_ms.insert(timer_ms);
      text.erase(0, end + 1);
    }
  }
  std::ranges::nth_element(waits_ms, waits_ms.begin() + lines / 2);
  waits.median_ms = waits_ms[lines / 2];
  std::printf("median of %zu lines %.2f ms, longest %.2f ms\n", lines, waits.median_ms,
              std::ranges::max(waits_ms));
  return waits;
}

/// A port as any program opens it.
Waits plainly_opened(UsbDevice& adapter, const std::string& path) {
  const link::Descriptor port(::open(path.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC));
  termios settings{};
  EXPECT_EQ(::tcgetattr(port.get(), &settings), 0);
  ::cfmakeraw(&settings);
  EXPECT_EQ(::tcsetattr(port.get(), TCSANOW, &settings), 0);
  return waits_of_lines(adapter, [&]() -> Came {
    pollfd ready{port.get(), POLLIN, 0};
    std::array<char, 512> buffer{};
    if (::poll(&ready, 1, 5000) <= 0) return {};
    const auto size = ::read(port.get(), buffer.data(), buffer.size());
    const auto at = monotonic();
    return {std::string(buffer.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0))), at};
  });
}

/// By the arrival stamps of our link.
Waits through_our_link(UsbDevice& adapter, const std::string& path) {
  link::asio::io_context io;
  const auto port =
      link::testing::open(io, "serial:" + path + "?emulated=1&baud=115200", link::Side::driver);
  if (!port) return {};
  const auto utc_minus_monotonic = link::now().time_since_epoch() - monotonic();
  link::testing::Buffer buffer(512);
  return waits_of_lines(adapter, [&]() -> Came {
    const auto received = link::testing::run(io, port->read(buffer));
    if (!received) return {};
    return {std::string(buffer.begin(), buffer.begin() + static_cast<long>(received->size)),
            received->at.time_since_epoch() - utc_minus_monotonic};
  });
}

/// The adapter's device file; empty within 10 s: there is none.
std::string port_of_the_adapter() {
  for (int tries = 0; tries < 500; ++tries) {
    for (const auto& one : std::filesystem::directory_iterator("/sys/class/tty"))
      if (std::filesystem::canonical(one).string().find("vhci_hcd") != std::string::npos)
        return "/dev/" + one.path().filename().string();
    ::usleep(20'000);
  }
  return {};
}

TEST(LatencyTimer, HoldsBytesBackAtAPlainlyOpenedPortAndNotAtOurs) {
  UsbDevice adapter("usb_serial.py");
  const auto path = port_of_the_adapter();
  ASSERT_FALSE(path.empty());
  runs_on({path});
  // 16 ms at power-up, half of it on the average. A busy machine adds to both alike.
  const Waits plain = plainly_opened(adapter, path);
  const Waits ours = through_our_link(adapter, path);
  EXPECT_EQ(plain.timers_ms, std::set{16});
  EXPECT_EQ(ours.timers_ms, std::set{1});
  EXPECT_GT(plain.median_ms, 5);
  EXPECT_LT(ours.median_ms, plain.median_ms - 4);
}

}  // namespace
}  // namespace drydock::ports
