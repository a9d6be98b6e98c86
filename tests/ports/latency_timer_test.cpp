// The latency timer of an FTDI chip, whose adapter is a program (usb_serial.py): it keeps bytes as
// the chip does. It needs the machine for itself, since it judges milliseconds.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <termios.h>

#include <algorithm>
#include <functional>
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

/// The median of how long the lines were under way. Each line says when its adapter had it.
double median_wait_ms(UsbDevice& adapter, const std::function<Came()>& read) {
  adapter.order("say " + std::to_string(lines));
  std::vector<double> waits_ms;
  for (std::string text; waits_ms.size() < lines;) {
    const Came came = read();
    if (came.text.empty()) {
      ADD_FAILURE() << "only " << waits_ms.size() << " lines came";
      return 0;
    }
    text += came.text;
    for (auto end = text.find('\n'); end != text.npos; end = text.find('\n')) {
      waits_ms.push_back(
          std::chrono::duration<double, std::milli>(came.at - nanoseconds{std::stoll(text)})
              .count());
      text.erase(0, end + 1);
    }
  }
  std::ranges::nth_element(waits_ms, waits_ms.begin() + lines / 2);
  std::printf("median of %zu lines %.2f ms, longest %.2f ms\n", lines, waits_ms[lines / 2],
              std::ranges::max(waits_ms));
  return waits_ms[lines / 2];
}

/// A port as any program opens it.
double plainly_opened(UsbDevice& adapter, const std::string& path) {
  const link::Descriptor port(::open(path.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC));
  termios settings{};
  EXPECT_EQ(::tcgetattr(port.get(), &settings), 0);
  ::cfmakeraw(&settings);
  EXPECT_EQ(::tcsetattr(port.get(), TCSANOW, &settings), 0);
  return median_wait_ms(adapter, [&]() -> Came {
    pollfd ready{port.get(), POLLIN, 0};
    std::array<char, 512> buffer{};
    if (::poll(&ready, 1, 5000) <= 0) return {};
    const auto size = ::read(port.get(), buffer.data(), buffer.size());
    const auto at = monotonic();
    return {std::string(buffer.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0))), at};
  });
}

/// By the arrival stamps of our link.
double through_our_link(UsbDevice& adapter, const std::string& path) {
  link::asio::io_context io;
  const auto port =
      link::testing::open(io, "serial:" + path + "?emulated=1&baud=115200", link::Side::driver);
  if (!port) return 0;
  const auto utc_minus_monotonic = link::now().time_since_epoch() - monotonic();
  link::testing::Buffer buffer(512);
  return median_wait_ms(adapter, [&]() -> Came {
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
  // 16 ms at power-up: half of it on the average.
  EXPECT_GT(plainly_opened(adapter, path), 5);
  EXPECT_LT(through_our_link(adapter, path), 3);
}

}  // namespace
}  // namespace drydock::ports
