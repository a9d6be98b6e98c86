// What an inline proxy adds: a message's way pty -> proxy -> pty beside its way over one bare pty,
// at the same time of the same run, both ends blocked in poll() as a program would be. The same
// on an emulated CAN bus with slcan adapters.
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/resource.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <boost/asio/post.hpp>
#include <chrono>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "drivers/link/link.hpp"
#include "hil/proxy/proxy.hpp"
#include "tests/bench/raw_pty.hpp"

namespace {

using namespace drydock;
using bench::Pty;
using Clock = std::chrono::steady_clock;

constexpr int rounds = 1500;
constexpr auto period = std::chrono::milliseconds{5};  // so that the processor idles in between

int open_raw(const std::string& path) {
  const int fd = open(path.c_str(), O_RDWR | O_NOCTTY);
  termios raw{};
  if (fd < 0 || tcgetattr(fd, &raw) != 0) return -1;
  cfmakeraw(&raw);
  tcsetattr(fd, TCSANOW, &raw);
  return fd;
}

/// Waits for whole messages on a descriptor, on a thread of its own, and notes when each was whole.
class Listener {
 public:
  Listener(int fd, std::size_t size) : fd_(fd), size_(size), thread_([this] { listen(); }) {}
  ~Listener() {
    done_ = true;
    thread_.join();
  }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  /// Microseconds from `sent` until the message was whole; below 0: it never was.
  double wait(Clock::time_point sent) {
    const auto give_up = Clock::now() + std::chrono::seconds{1};
    while (at_ns_ == 0)
      if (Clock::now() > give_up)
        return -1;
      else
        std::this_thread::sleep_for(std::chrono::milliseconds{1});
    const std::int64_t at = at_ns_.exchange(0);
    return static_cast<double>(at - sent.time_since_epoch().count()) * 1e-3;
  }

 private:
  void listen() {
    std::vector<char> buffer(4096);
    std::size_t got = 0;
    while (!done_) {
      pollfd p{fd_, POLLIN, 0};
      if (poll(&p, 1, 20) != 1) continue;
      const auto n = read(fd_, buffer.data(), buffer.size());
      if (n > 0) got += static_cast<std::size_t>(n);
      if (got < size_) continue;
      got = 0;
      at_ns_ = Clock::now().time_since_epoch().count();
    }
  }

  int fd_;
  std::size_t size_;
  std::atomic<bool> done_{false};
  std::atomic<std::int64_t> at_ns_{0};
  std::thread thread_;
};

struct Figures {
  double p50 = 0, p99 = 0;
};

Figures figures_of(std::vector<double> us) {
  std::ranges::sort(us);
  if (us.empty()) return {};
  return {us[us.size() / 2], us[us.size() * 99 / 100]};
}

/// A proxy on a thread of its own, as the program runs it.
class Running {
 public:
  Running(const std::string& real, const std::string& virt) {
    proxy::ProxyOptions options;
    options.real = link::parse_uri(real).value();
    options.virt = link::parse_uri(virt).value();
    options.device.link = real;
    options.schedule = std::make_shared<fault::Schedule>(link::now());
    options.say = [this](const std::string& line) {
      ready_ = ready_ || line.starts_with("drivers");
    };
    proxy_ = proxy::Proxy::start(io_, std::move(options));
    thread_ = std::thread([this] { io_.run(); });
    while (!ready_) std::this_thread::sleep_for(period);
  }
  ~Running() { finish(); }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  /// Ends it; what it measured itself, from a read's return to the write's.
  const proxy::Latency& finish() {
    if (thread_.joinable()) {
      boost::asio::post(io_, [this] { proxy_->finish(); });
      thread_.join();
    }
    return proxy_->latency();
  }

 private:
  boost::asio::io_context io_{1};
  std::unique_ptr<proxy::Proxy> proxy_;
  std::atomic<bool> ready_{false};
  std::thread thread_;
};

void say(int fd, const std::string& message) {
  if (write(fd, message.data(), message.size()) != static_cast<ssize_t>(message.size()))
    std::abort();
}

/// One by one over the bare line and through the proxy, in turns.
void compare(const char* what, int bare_in, int bare_out, int device, int drivers,
             const std::string& message) {
  Listener bare(bare_out, message.size()), behind(drivers, message.size());
  std::vector<double> alone, proxied;
  for (int i = 0; i < rounds; ++i) {
    for (const bool through : {false, true}) {
      std::this_thread::sleep_for(period);
      const auto sent = Clock::now();
      say(through ? device : bare_in, message);
      const double us = (through ? behind : bare).wait(sent);
      if (us >= 0) (through ? proxied : alone).push_back(us);
    }
  }
  const auto a = figures_of(alone), p = figures_of(proxied);
  fmt::print(
      "{:24} bare p50 {:6.0f} p99 {:6.0f}   proxied p50 {:6.0f} p99 {:6.0f}   added p50 "
      "{:6.0f} p99 {:6.0f} us   lost {}\n",
      what, a.p50, a.p99, p.p50, p.p99, p.p50 - a.p50, p.p99 - a.p99,
      2 * rounds - alone.size() - proxied.size());
  std::fflush(stdout);
}

void print_own(Running& proxy) {
  const auto& own = proxy.finish();
  const auto us = [&](double share) {
    return static_cast<double>(own.percentile(share).count()) * 1e-3;
  };
  fmt::print("{:24} in the proxy, from read to written: p50 {:.0f} p99 {:.0f} us of {}\n", "",
             us(0.5), us(0.99), own.count());
}

void bytes_over_ptys(std::size_t size) {
  const Pty bare, device;
  const std::string virt = "/tmp/drydock-proxy-bench-" + std::to_string(getpid());
  Running proxy("serial:" + std::string(device.name) + "?baud=115200", "pty:" + virt);
  const int drivers = open_raw(virt);
  compare(fmt::format("{} bytes", size).c_str(), bare.master, bare.slave, device.master, drivers,
          std::string(size, 'x'));
  print_own(proxy);
  close(drivers);
}

/// The bare line carries the same text: an slcan adapter is one.
void frames_over_slcan() {
  const Pty bare, device;
  const std::string virt = "/tmp/drydock-proxy-bench-can-" + std::to_string(getpid());
  Running proxy("slcan:" + std::string(device.name), "slcan:pty:" + virt);
  const int drivers = open_raw(virt);
  say(drivers, "\rC\rS5\rO\r");
  std::this_thread::sleep_for(10 * period);
  char answers[64];
  pollfd p{drivers, POLLIN, 0};
  while (poll(&p, 1, 50) == 1 && read(drivers, answers, sizeof answers) > 0) {
  }
  compare("slcan frame", bare.master, bare.slave, device.master, drivers,
          "T0CF02A8080102030405060708\r");
  print_own(proxy);
  close(drivers);
}

}  // namespace

int main() {
  fmt::print("nice {}\n", getpriority(PRIO_PROCESS, 0));
  for (const std::size_t size : {1, 40, 1000}) bytes_over_ptys(size);
  frames_over_slcan();
}
