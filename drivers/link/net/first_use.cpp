#include "drivers/link/net/first_use.hpp"

#include <boost/asio/error.hpp>
#include <utility>

namespace drydock::link {

FirstUse::FirstUse(const asio::any_io_executor& executor, Work work)
    : work_(std::move(work)), changed_(std::make_shared<io::Signal>(executor)) {}

Task<void> FirstUse::done() {
  while (state_ == State::working) co_await changed_->wait();
  if (state_ == State::idle) {
    state_ = State::working;
    failure_ = co_await work_();
    if (state_ == State::working) state_ = State::done;
    changed_->notify();
  }
  if (closed()) co_return ErrorCode(asio::error::operation_aborted);
  if (failure_) co_return failure_;
  co_return boost::system::result<void>{};
}

void FirstUse::close() {
  state_ = State::closed;
  changed_->notify();
}

}  // namespace drydock::link
