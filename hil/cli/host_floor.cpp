#include "hil/cli/host_floor.hpp"

#include <pty.h>
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

namespace drydock::cli {
namespace {

namespace asio = boost::asio;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds period{5};

double us_since(Clock::time_point then) {
  return std::chrono::duration<double, std::micro>(Clock::now() - then).count();
}

}  // namespace

struct HostFloor::Probe {
  Probe() : timer(io), near(io), far(io) {
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
  }

  void wait() {
    due += period;
    timer.expires_at(due);
    timer.async_wait([this](const boost::system::error_code& error) {
      if (error) return;
      times.timer_late_us.push_back(us_since(due));
      times.timer_at.push_back(link::steady_now());
      due = std::max(due, Clock::now() - period);  // a stall counts once
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

  asio::io_context io{1};
  asio::steady_timer timer;
  asio::posix::stream_descriptor near, far;
  std::array<char, 16> buffer{};
  Clock::time_point due, written;
  HostTimes times;
  std::jthread thread;
};

HostFloor::HostFloor() : probe_(std::make_unique<Probe>()) {}

HostFloor::~HostFloor() {
  if (probe_->thread.joinable()) stop();
}

HostTimes HostFloor::stop() {
  asio::post(probe_->io, [this] {
    boost::system::error_code gone;
    probe_->timer.cancel();
    probe_->far.close(gone);
    probe_->near.close(gone);
  });
  probe_->thread.join();
  return std::move(probe_->times);
}

}  // namespace drydock::cli
