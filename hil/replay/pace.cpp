#include "hil/replay/pace.hpp"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <boost/asio/executor_work_guard.hpp>

namespace drydock::replay {

namespace {
constexpr std::chrono::milliseconds between_looks{50};  ///< between two checks for Ctrl-C
}

bool Pace::wait(measurement::Stamp at, const terminal::InterruptFlag& interrupted) {
  if (!real_time()) return !interrupted.set();
  if (!begun_) {
    begun_ = true;
    first_ = at;
    wall_first_ = Clock::now();
  }
  const auto due = wall_first_ + std::chrono::duration_cast<Clock::duration>(
                                     std::chrono::duration<double, std::nano>(
                                         static_cast<double>((at - first_).count()) / speed_));
  const auto busy = boost::asio::make_work_guard(io_);
  io_.restart();
  io_.poll();
  while (Clock::now() < due && !interrupted.set())
    io_.run_until(std::min(due, Clock::now() + between_looks));
  return !interrupted.set();
}

bool Steps::next(const terminal::InterruptFlag& interrupted) {
  char first = 0;
  for (bool at_start = true; !interrupted.set();) {
    pollfd ready{fileno(in_), POLLIN, 0};
    if (::poll(&ready, 1, static_cast<int>(between_looks.count())) <= 0) continue;
    char c = 0;
    if (::read(fileno(in_), &c, 1) != 1) return false;
    if (c == '\n') return first != 'q';
    if (std::exchange(at_start, false)) first = c;
  }
  return false;
}

}  // namespace drydock::replay
