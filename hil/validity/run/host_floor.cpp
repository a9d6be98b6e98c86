#include "hil/validity/run/host_floor.hpp"

#include <pthread.h>
#include <pty.h>
#include <sched.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>

#include "drivers/link/clock.hpp"

namespace drydock::validity {
namespace {

namespace asio = boost::asio;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds period{5};

std::vector<int> processors() {
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  std::vector<int> all;
  if (::sched_getaffinity(0, sizeof allowed, &allowed) == 0)
    for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu)
      if (CPU_ISSET(cpu, &allowed)) all.push_back(cpu);
  return all;
}

void keep_on(int processor, pthread_t thread) {
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(processor, &one);
  ::pthread_setaffinity_np(thread, sizeof one, &one);
}

void put_ahead_of_us(pthread_t thread) {
  int policy = 0;
  sched_param scheduling{};
  ::pthread_getschedparam(::pthread_self(), &policy, &scheduling);
  if (policy != SCHED_FIFO) return;
  ++scheduling.sched_priority;
  ::pthread_setschedparam(thread, policy, &scheduling);
}

double us_since(Clock::time_point then) {
  return std::chrono::duration<double, std::micro>(Clock::now() - then).count();
}

}  // namespace

struct HostFloor::Probe {
  explicit Probe(int processor) : timer(io), near(io), far(io) {
    int ends[2] = {-1, -1};
    termios raw{};
    ::cfmakeraw(&raw);
    if (::openpty(&ends[0], &ends[1], nullptr, &raw, nullptr) != 0)
      throw std::system_error(errno, std::generic_category(), "cannot make a pty");
    near.assign(ends[0]);
    far.assign(ends[1]);
    due = Clock::now();
    wait();
    hear();
    thread = std::jthread([this] { io.run(); });
    keep_on(processor, thread.native_handle());
    put_ahead_of_us(thread.native_handle());
  }

  void wait() {
    due += period;
    timer.expires_at(due);
    timer.async_wait([this](const boost::system::error_code& error) {
      if (error || stopped) return;  // an expired timer cannot be cancelled any more
      times.timer_late_us.push_back(us_since(due));
      times.timer_at.push_back(link::steady_now());
      due = std::max(due, Clock::now() - period);  // a stall counts only once
      const char byte = 0;
      written = Clock::now();
      boost::system::error_code lost;
      near.write_some(asio::buffer(&byte, 1), lost);
      wait();
    });
  }

  void hear() {
    far.async_read_some(asio::buffer(buffer),
                        [this](const boost::system::error_code& error, std::size_t) {
                          if (error) return;
                          times.pty_hop_us.push_back(us_since(written));
                          times.pty_at.push_back(link::steady_now());
                          hear();
                        });
  }

  HostTimes stop() {
    asio::post(io, [this] {
      boost::system::error_code gone;
      stopped = true;
      timer.cancel();
      far.close(gone);
      near.close(gone);
    });
    thread.join();
    return std::move(times);
  }

  asio::io_context io{1};
  asio::steady_timer timer;
  asio::posix::stream_descriptor near, far;
  std::array<char, 16> buffer{};
  Clock::time_point due, written;
  HostTimes times;
  bool stopped = false;
  std::jthread thread;
};

HostFloor::HostFloor() {
  for (const int processor : processors()) probes_.push_back(std::make_unique<Probe>(processor));
}

HostFloor::~HostFloor() { stop(); }

HostTimes HostFloor::stop() {
  HostTimes all;
  const auto append = [](auto& to, const auto& more) {
    to.insert(to.end(), more.begin(), more.end());
  };
  for (const auto& probe : probes_) {
    const HostTimes one = probe->stop();
    append(all.timer_late_us, one.timer_late_us);
    append(all.timer_at, one.timer_at);
    append(all.pty_hop_us, one.pty_hop_us);
    append(all.pty_at, one.pty_at);
  }
  probes_.clear();
  return all;
}

}  // namespace drydock::validity
