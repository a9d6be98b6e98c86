#include "drivers/io/signal.hpp"

#include <boost/asio/post.hpp>

#include "drivers/io/as_outcome.hpp"

namespace drydock::io {

namespace {
constexpr auto never = boost::asio::steady_timer::time_point::max();
}

Signal::Signal(const boost::asio::any_io_executor& executor) : timer_(executor, never) {}

boost::asio::awaitable<void> Signal::wait_until(std::optional<measurement::Stamp> deadline,
                                                measurement::Stamp now) {
  if (deadline)
    timer_.expires_after(*deadline - now);
  else if (timer_.expiry() != never)  // a new time ends the waits of others
    timer_.expires_at(never);
  co_await timer_.async_wait(as_outcome);
}

void Signal::notify() {
  boost::asio::post(timer_.get_executor(), [self = shared_from_this()] { self->timer_.cancel(); });
}

}  // namespace drydock::io
