#pragma once

#include <fmt/format.h>

#include <atomic>
#include <boost/asio/post.hpp>
#include <chrono>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "drivers/link/clock.hpp"
#include "drivers/link/link.hpp"
#include "hil/proxy/proxy.hpp"
#include "tests/bench/percentiles.hpp"
#include "tests/bench/raw_pty.hpp"

/// Compares a message through a proxy with a message over one bare hop, in the same run at the same
/// time. Both ends block in poll(), as in a program.
namespace drydock::bench {

using Clock = std::chrono::steady_clock;

inline constexpr int rounds = 1500;
/// The pause lets the processor idle in between.
inline constexpr auto period = std::chrono::milliseconds{5};

/// Waits for complete messages on a descriptor in its own thread, and records when each was
/// complete.
class Listener {
 public:
  Listener(int fd, std::size_t size) : fd_(fd), size_(size), thread_([this] { listen(); }) {}
  ~Listener() {
    done_ = true;
    thread_.join();
  }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  /// Microseconds from `sent` until the message was complete. Below 0: it was never complete.
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
      if (!wait_readable(fd_, 20)) continue;
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

/// A proxy in its own thread, run as the program runs it.
class Running {
 public:
  Running(const std::string& real, const std::string& virt) {
    proxy::ProxyOptions options;
    options.real = link::parse_uri(real).value();
    options.virt = link::parse_uri(virt).value();
    options.device.link = real;
    options.schedule = std::make_shared<fault::Schedule>(link::steady_now());
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

  /// Ends the proxy. Returns its own measurement, from the return of a read to the return of the
  /// write.
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

inline void say(int fd, const std::string& message) {
  if (write(fd, message.data(), message.size()) != static_cast<ssize_t>(message.size()))
    std::abort();
}

/// Sends messages one by one, alternately over the bare line and through the proxy.
inline void compare(const char* what, int bare_in, int bare_out, int device, int drivers,
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
  const auto a = percentiles_of(alone), p = percentiles_of(proxied);
  fmt::print(
      "{:24} bare p50 {:6.0f} p99 {:6.0f}   proxied p50 {:6.0f} p99 {:6.0f}   added p50 "
      "{:6.0f} p99 {:6.0f} us   lost {}\n",
      what, a.p50, a.p99, p.p50, p.p99, p.p50 - a.p50, p.p99 - a.p99,
      2 * rounds - alone.size() - proxied.size());
  std::fflush(stdout);
}

inline void print_own(Running& proxy) {
  const auto& own = proxy.finish();
  const auto us = [&](double share) {
    return static_cast<double>(own.percentile(share).count()) * 1e-3;
  };
  fmt::print("{:24} in the proxy, from read to written: p50 {:.0f} p99 {:.0f} us of {}\n", "",
             us(0.5), us(0.99), own.count());
}

}  // namespace drydock::bench
