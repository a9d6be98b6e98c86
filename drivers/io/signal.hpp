#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/asio/steady_timer.hpp>
#include <memory>
#include <optional>

#include "drivers/measurement/stamp.hpp"

namespace drydock::io {

/// Wakes coroutines that wait for a condition or for a deadline. They check both before they wait
/// and again when they wake: a wait may also end without a reason. Another thread may call
/// notify().
class Signal : public std::enable_shared_from_this<Signal> {
 public:
  explicit Signal(const boost::asio::any_io_executor& executor);

  /// Until notify().
  boost::asio::awaitable<void> wait() { return wait_until({}, {}); }
  /// Until notify(), but not after `deadline`, on the clock that now shows `now`. Only one
  /// coroutine may wait for a deadline, and no other may wait meanwhile.
  boost::asio::awaitable<void> wait_until(std::optional<measurement::Stamp> deadline,
                                          measurement::Stamp now);

  /// Posts the wake-up, so that it comes after a waiter that is about to suspend.
  void notify();

 private:
  boost::asio::steady_timer timer_;
};

}  // namespace drydock::io
