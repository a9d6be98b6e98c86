#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>

#include "drivers/host/follower.hpp"
#include "drivers/host/wake_times.hpp"

namespace drydock::host {

/// Tells a follower when the thread of an io_context woke late, on the clock of all stamps.
class WakeWatch {
 public:
  /// The follower must outlive the watch.
  WakeWatch(boost::asio::io_context& io, Follower& to) : to_(to), timer_(io) {}

  void start();
  void stop();
  /// Call it before what links brought is told: they may be served before the timer.
  void look();

 private:
  void keep_asking();

  Follower& to_;
  boost::asio::steady_timer timer_;
  WakeTimes times_{std::chrono::steady_clock::now()};
  bool stopped_ = true;  ///< an expired timer can no longer be cancelled
};

}  // namespace drydock::host
