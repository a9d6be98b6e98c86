#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <memory>

#include "drivers/io/as_outcome.hpp"

namespace drydock::io {

/// Wakes coroutines that wait for a condition. They check the condition before they wait and again
/// when they wake. Another thread may call notify().
class Signal : public std::enable_shared_from_this<Signal> {
 public:
  explicit Signal(const boost::asio::any_io_executor& executor)
      : timer_(executor, boost::asio::steady_timer::time_point::max()) {}

  boost::asio::awaitable<void> wait() { co_await timer_.async_wait(as_outcome); }

  /// Posts the wake-up, so that it comes after a waiter that is about to suspend.
  void notify() {
    boost::asio::post(timer_.get_executor(),
                      [self = shared_from_this()] { self->timer_.cancel(); });
  }

 private:
  boost::asio::steady_timer timer_;
};

}  // namespace drydock::io
