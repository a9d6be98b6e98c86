#include "hil/pilot/real_time/real_time_pilot.hpp"

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>

#include "drivers/link/clock.hpp"

namespace drydock::pilot {

namespace {

/// A bus that was silent for longer may have been closed and opened.
constexpr std::chrono::seconds longest_silence{2};

}  // namespace

RealTimePilot::RealTimePilot(boost::asio::io_context& io, const rig_config::Rig& rig, Stamp start,
                             const OrderPorts::Send& send, OrderPorts::Say say)
    : io_(io),
      pilot_(rig, start, send, std::move(say)),
      clock_(std::make_shared<io::Signal>(io.get_executor())) {
  for (const std::string& link : pilot_.ports().links()) heard_at_[link];
}

void RealTimePilot::start() { boost::asio::co_spawn(io_, keep_time(), boost::asio::detached); }

void RealTimePilot::stop() {
  stopped_ = true;
  clock_->notify();
}

void RealTimePilot::on_frame(std::string_view link, shell::Direction way,
                             const wire::CanFrame& frame, Stamp) {
  const auto bus = heard_at_.find(link);
  if (way != shell::Direction::received || frame.error || bus == heard_at_.end()) return;
  const Stamp now = link::steady_now();
  if (!bus->second || now - *bus->second > longest_silence) pilot_.ports().restart(bus->first, now);
  bus->second = now;
  const auto due = pilot_.deadline();
  pilot_.ports().receive(bus->first, frame, now);
  if (pilot_.deadline() != due) clock_->notify();
}

boost::asio::awaitable<void> RealTimePilot::keep_time() {
  while (!stopped_) {
    const Stamp now = link::steady_now();
    if (const auto due = pilot_.deadline(); due && *due <= now) pilot_.tick(now);
    co_await clock_->wait_until(pilot_.deadline(), now);
  }
}

}  // namespace drydock::pilot
