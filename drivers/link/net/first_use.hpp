#pragma once

#include <functional>

#include "drivers/io/signal.hpp"
#include "drivers/link/opening.hpp"

namespace drydock::link {

/// What a link does once, at its first read or write: find its host, connect. A read and a write
/// may both be first; then one does it and the other waits for the outcome.
class FirstUse {
 public:
  using Work = std::function<asio::awaitable<ErrorCode>()>;

  FirstUse(const asio::any_io_executor& executor, Work work);

  Task<void> done();
  void close();  ///< the link is closed: done() says operation_aborted from now on
  bool closed() const { return state_ == State::closed; }

 private:
  enum class State : std::uint8_t { idle, working, done, closed };

  Work work_;
  std::shared_ptr<io::Signal> changed_;  ///< signalled when it is no longer working
  State state_ = State::idle;
  ErrorCode failure_;
};

}  // namespace drydock::link
