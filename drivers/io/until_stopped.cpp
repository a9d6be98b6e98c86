#include "drivers/io/until_stopped.hpp"

#include <boost/asio/post.hpp>
#include <csignal>
#include <utility>

#include "drivers/measurement/stamp.hpp"
#include "drivers/terminal/dead_terminal.hpp"
#include "drivers/terminal/early_end.hpp"
#include "drivers/terminal/hangup.hpp"
#include "drivers/terminal/interrupt_flag.hpp"

namespace drydock::io {

UntilStopped::UntilStopped(boost::asio::io_context& io, double duration_s,
                           std::function<void()> stop)
    : stop_(std::move(stop)), signals_(io), timer_(io) {
  for (const int signal : {SIGINT, SIGTERM, SIGPIPE}) signals_.add(signal);
  if (!terminal::hangup_is_ignored()) signals_.add(SIGHUP);
  const bool has_end = duration_s > 0;
  signals_.async_wait([this, has_end](const boost::system::error_code& ec, int signal) {
    if (ec || stopped_) return;
    terminal::leave_dead_terminal();
    if (signal == SIGPIPE) terminal::forget_unread_lines();
    end_early(has_end);
  });
  // A signal that came before went to the flag alone.
  if (terminal::interrupt_is_noted())
    boost::asio::post(io, [this, has_end] { end_early(has_end); });
  if (duration_s <= 0) return;
  timer_.expires_after(measurement::from_seconds(duration_s));
  timer_.async_wait([this](const boost::system::error_code& ec) {
    if (!ec) this->stop();
  });
}

void UntilStopped::end_early(bool has_end) {
  if (stopped_) return;
  interrupted_ = true;
  if (has_end) terminal::note_early_end();
  stop();
}

void UntilStopped::stop() {
  if (std::exchange(stopped_, true)) return;
  signals_.cancel();
  signals_.clear();
  for (const int second : {SIGINT, SIGTERM}) std::signal(second, terminal::end_at_once);
  for (const int again : {SIGHUP, SIGPIPE}) std::signal(again, SIG_IGN);
  timer_.cancel();
  stop_();
}

}  // namespace drydock::io
