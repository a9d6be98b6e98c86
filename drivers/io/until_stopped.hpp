#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <functional>

namespace drydock::io {

/// How a program that runs until it is told ends: at Ctrl-C, SIGTERM, or when its time is over. A
/// second Ctrl-C ends it at once.
class UntilStopped {
 public:
  /// `stop` is called once and lets `io` run out of work. A duration of 0 never ends.
  UntilStopped(boost::asio::io_context& io, double duration_s, std::function<void()> stop);

  void stop();  ///< as if the time were over

 private:
  std::function<void()> stop_;
  boost::asio::signal_set signals_;
  boost::asio::steady_timer timer_;
  bool stopped_ = false;  ///< an expired timer can no longer be cancelled
};

}  // namespace drydock::io
