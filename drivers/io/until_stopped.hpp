#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <functional>

namespace drydock::io {

/// Ends a program that runs until it is told to end: at Ctrl-C, at SIGTERM, when its terminal
/// hangs up (a dropped ssh; not under nohup), when nobody reads what it prints any more (a pipe
/// whose other end has gone), or when its time is over; and at once if such a signal has set a
/// terminal::InterruptFlag that lives. A second Ctrl-C ends it at once. A signal before the end of
/// a given time is noted as an early end.
class UntilStopped {
 public:
  /// Calls `stop` once; `stop` must let `io` run out of work. With a duration of 0 there is no time
  /// limit.
  UntilStopped(boost::asio::io_context& io, double duration_s, std::function<void()> stop);

  void stop();  ///< does the same as the end of the time

  bool interrupted() const { return interrupted_; }  ///< a signal ended it

 private:
  void end_early(bool has_end);

  std::function<void()> stop_;
  boost::asio::signal_set signals_;
  boost::asio::steady_timer timer_;
  bool interrupted_ = false;
  bool stopped_ = false;  ///< an expired timer can no longer be cancelled
};

}  // namespace drydock::io
