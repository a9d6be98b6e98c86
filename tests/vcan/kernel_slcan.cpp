#include "tests/vcan/kernel_slcan.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <net/if.h>
#include <poll.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <termios.h>

#include <array>

#include "drivers/link/can/can_interface.hpp"
#include "tests/hil/survive/bench.hpp"
#include "tests/vcan/process.hpp"

namespace drydock::vcan {
namespace {

using device::State;
using link::Descriptor;

constexpr std::string_view depth = "T0DF50B23800E80300000000FF\r";

/// Takes the discipline; the interface that it makes, else nothing.
std::string attach(int line) {
  const int slcan_discipline = 17;
  std::array<char, IFNAMSIZ> name{};
  if (::ioctl(line, TIOCSETD, &slcan_discipline) != 0) return {};
  return ::ioctl(line, SIOCGIFNAME, name.data()) == 0 ? name.data() : std::string();
}

void make_raw(int line) {
  termios settings{};
  if (::tcgetattr(line, &settings) != 0) return;
  ::cfmakeraw(&settings);
  settings.c_cflag |= CLOCAL | CREAD;
  ::tcsetattr(line, TCSANOW, &settings);
}

bool says(const fault::testing::Bench& bench, std::string_view text) {
  return bench.health().last_error.view().find(text) != std::string_view::npos;
}

rig_config::DeviceConfig depth_on(const KernelSlcan& slcan) {
  return fault::testing::bus_depth("socketcan:" + slcan.interface() + "?emulated=1");
}

}  // namespace

KernelSlcan::KernelSlcan(Descriptor kernels, Descriptor adapters)
    : kernels_(std::move(kernels)), adapters_(std::move(adapters)) {
  for (const auto* line : {&kernels_, &adapters_}) make_raw(line->get());
  interface_ = attach(kernels_.get());
  adapter_ = std::thread([this] { serve(); });
}

KernelSlcan::~KernelSlcan() {
  ends_ = true;
  adapter_.join();
}

bool KernelSlcan::bring_up(const std::string& settings) const {
  return run_program({"sh", "-c",
                      "ip link set " + interface_ + " up type can bitrate 250000 " + settings}) ==
         0;
}

void KernelSlcan::say(std::string_view line) {
  if (line.starts_with("sb")) is_open_ = false;
  const std::string whole = std::string(line) + '\r';
  EXPECT_EQ(::write(adapters_.get(), whole.data(), whole.size()),
            static_cast<ssize_t>(whole.size()));
}

std::string KernelSlcan::commands() const {
  const std::lock_guard lock(mutex_);
  return commands_;
}

void KernelSlcan::obey(std::string_view command) {
  if (command == "O" || command == "L") is_open_ = true;
  if (command == "C") is_open_ = false;
}

/// It reads always: the kernel waits until somebody has read its command.
void KernelSlcan::serve() {
  using namespace std::chrono_literals;
  std::string line;
  auto next = std::chrono::steady_clock::now();
  while (!ends_) {
    pollfd ready{adapters_.get(), POLLIN, 0};
    char c = 0;
    if (::poll(&ready, 1, 10) > 0 && ::read(adapters_.get(), &c, 1) == 1) {
      line += c;
      if (c != '\r') continue;
      obey(std::string_view(line).substr(0, line.size() - 1));
      const std::lock_guard lock(mutex_);
      commands_ += std::exchange(line, {});
    }
    if (!is_open_ || std::chrono::steady_clock::now() < next) continue;
    next = std::chrono::steady_clock::now() + 100ms;
    (void)!::write(adapters_.get(), depth.data(), depth.size());
  }
}

std::unique_ptr<KernelSlcan> slcan_on_pty() {
  Descriptor master(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC));
  EXPECT_EQ(::grantpt(master.get()), 0);
  EXPECT_EQ(::unlockpt(master.get()), 0);
  Descriptor slave(::open(::ptsname(master.get()), O_RDWR | O_NOCTTY | O_CLOEXEC));
  return std::make_unique<KernelSlcan>(std::move(slave), std::move(master));
}

void expect_every_state_is_named(KernelSlcan& slcan) {
  fault::testing::Bench bench(depth_on(slcan), fault::testing::nobody);
  ASSERT_TRUE(bench.reaches(State::streaming)) << bench.health().status.view();
  const auto& first = std::get<measurement::DepthSample>(bench.heard.front());
  EXPECT_EQ(first.altitude_m, 10);
  std::uint64_t told = 0;
  // linux/drivers/net/can/slcan/slcan-core.c, slcan_bump_err() and slcan_bump_state()
  for (const auto& [line, text] : {std::pair{"e1a", "no other node acknowledges"},
                                   {"e1c", "bus error"},
                                   {"e1o", "receive overflow"},
                                   {"e1O", "transmit overflow"},
                                   {"sw100020", "error warning: more than 95 frames were received"},
                                   {"sp096130", "error-passive: more than 127 frames sent"},
                                   {"sa000000", "error-active again"}}) {
    slcan.say(line);
    EXPECT_TRUE(bench.until([&, said = text] { return says(bench, said); }))
        << line << ": " << bench.health().last_error.view();
    EXPECT_EQ(bench.health().error_frames, ++told) << line;
  }
  EXPECT_TRUE(bench.hears_again());
  EXPECT_EQ(bench.states.back(), State::streaming);
}

void expect_bus_off_ends(KernelSlcan& slcan) {
  fault::testing::Bench bench(depth_on(slcan), fault::testing::nobody);
  ASSERT_TRUE(bench.reaches(State::streaming)) << bench.health().status.view();
  slcan.say("sb000255");
  ASSERT_TRUE(bench.until([&] { return says(bench, "bus-off"); }));
  EXPECT_EQ(link::find_can_interface(slcan.interface())->state, "BUS-OFF");
  ASSERT_FALSE(link::set_interface_up(slcan.interface(), false));
  ASSERT_TRUE(bench.reaches(State::backing_off));
  ASSERT_FALSE(link::set_interface_up(slcan.interface(), true));
  EXPECT_TRUE(bench.reaches(State::streaming)) << bench.health().status.view();
  EXPECT_TRUE(bench.hears_again());
}

}  // namespace drydock::vcan
