#pragma once

#include <boost/asio/io_context.hpp>
#include <chrono>
#include <cstdio>

#include "drivers/measurement/stamp.hpp"
#include "drivers/terminal/interrupt_flag.hpp"

namespace drydock::replay {

/// Decides when the next event of a recording is due: at once, or at `speed` times the original
/// speed. Due times count from the first event, so lateness does not add up. During a wait the
/// io_context runs, which serves viewers and links.
class Pace {
 public:
  /// `speed` 0: as fast as possible.
  Pace(boost::asio::io_context& io, double speed) : io_(io), speed_(speed) {}

  bool real_time() const { return speed_ > 0; }
  /// False if `interrupted` became true during the wait.
  bool wait(measurement::Stamp at, const terminal::InterruptFlag& interrupted);

 private:
  using Clock = std::chrono::steady_clock;

  boost::asio::io_context& io_;
  double speed_;
  bool begun_ = false;
  measurement::Stamp first_{};
  Clock::time_point wall_first_;
};

/// Waits before each message until a line comes from `in`. End of file or "q" ends the replay.
class Steps {
 public:
  explicit Steps(std::FILE* in) : in_(in) {}
  bool next(const terminal::InterruptFlag& interrupted);  ///< false: the replay must end

 private:
  std::FILE* in_;
};

}  // namespace drydock::replay
