#pragma once

#include <boost/asio/io_context.hpp>
#include <chrono>
#include <cstdio>

#include "drivers/measurement/stamp.hpp"
#include "drivers/terminal/interrupt_flag.hpp"

namespace drydock::replay {

/// When the next of a recording's events has its turn: at once, or `speed` times as fast as it was.
/// Due times count from the first, so that lateness does not add up. What waits in the io_context,
/// viewers and links, goes on meanwhile.
class Pace {
 public:
  /// `speed` 0: as fast as it goes.
  Pace(boost::asio::io_context& io, double speed) : io_(io), speed_(speed) {}

  bool real_time() const { return speed_ > 0; }
  /// False: `interrupted` became true while waiting.
  bool wait(measurement::Stamp at, const terminal::InterruptFlag& interrupted);

 private:
  using Clock = std::chrono::steady_clock;

  boost::asio::io_context& io_;
  double speed_;
  bool begun_ = false;
  measurement::Stamp first_{};
  Clock::time_point wall_first_;
};

/// Stops before each message until a line comes from `in`. End of file or "q" ends the replay.
class Steps {
 public:
  explicit Steps(std::FILE* in) : in_(in) {}
  bool next(const terminal::InterruptFlag& interrupted);  ///< false: no more

 private:
  std::FILE* in_;
};

}  // namespace drydock::replay
