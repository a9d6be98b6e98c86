#include "hil/pilot/real_time/order_bus.hpp"

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <utility>

#include "drivers/link/clock.hpp"
#include "drivers/link/reading.hpp"

namespace drydock::pilot {

namespace {

constexpr std::chrono::milliseconds try_again_after{200};

}  // namespace

OrderBus::OrderBus(const boost::asio::any_io_executor& executor, link::Uri uri, Hooks hooks)
    : executor_(executor),
      uri_(std::move(uri)),
      hooks_(std::move(hooks)),
      patience_(std::make_shared<io::Signal>(executor)),
      waiting_(std::make_shared<io::Signal>(executor)) {}

void OrderBus::start() {
  const auto run = [this](boost::asio::awaitable<void> (OrderBus::*coroutine)()) {
    boost::asio::co_spawn(
        executor_, [self = shared_from_this(), coroutine] { return (self.get()->*coroutine)(); },
        boost::asio::detached);
  };
  run(&OrderBus::serve);
  run(&OrderBus::write_out);
}

void OrderBus::stop() {
  stopped_ = true;
  if (link_) link_->close();
  patience_->notify();
  waiting_->notify();
}

void OrderBus::send(const wire::CanFrame& frame) {
  if (!link_) return;
  outbox_.push_back(frame);
  waiting_->notify();
}

void OrderBus::hear(const wire::CanFrame& frame, link::Stamp) {
  if (!frame.error) hooks_.heard(frame);
}

boost::asio::awaitable<void> OrderBus::serve() {
  while (!stopped_) {
    if (auto opened = link::open_frames(executor_, uri_, link::Side::driver)) {
      link_ = std::move(*opened);
      hooks_.opened();
      const auto open = link_;
      co_await link::read_until_lost<link::FrameLink>(*open,
                                                      std::bind_front(&OrderBus::hear, this));
      open->close();
      link_.reset();
      outbox_.clear();
    }
    if (stopped_) break;
    const auto now = link::steady_now();
    co_await patience_->wait_until(now + try_again_after, now);
  }
  waiting_->notify();
}

boost::asio::awaitable<void> OrderBus::write_out() {
  while (!stopped_) {
    while (!outbox_.empty() && link_) {
      const auto open = link_;
      const wire::CanFrame frame = outbox_.front();
      outbox_.pop_front();
      co_await open->write(frame);  // an error ends the reading too, which opens the bus again
    }
    if (!stopped_) co_await waiting_->wait();
  }
}

}  // namespace drydock::pilot
