#include "hil/pilot/real_time/real_time_pilot.hpp"

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>

#include "drivers/link/clock.hpp"

namespace drydock::pilot {

RealTimePilot::RealTimePilot(boost::asio::io_context& io, const rig_config::Rig& rig, Stamp start,
                             OrderPorts::Say say)
    : io_(io),
      pilot_(
          rig, start,
          [this](const std::string& link, const wire::CanFrame& frame) { send(link, frame); },
          std::move(say)),
      clock_(std::make_shared<io::Signal>(io.get_executor())) {
  for (const std::string& link : pilot_.ports().links()) {
    const OrderBus::Hooks hooks{[this, link] {
                                  pilot_.ports().restart(link, link::steady_now());
                                  clock_->notify();
                                },
                                [this, link](const wire::CanFrame& frame) {
                                  pilot_.ports().receive(link, frame, link::steady_now());
                                  clock_->notify();
                                }};
    buses_[link] = std::make_shared<OrderBus>(io.get_executor(), *link::parse_uri(link), hooks);
  }
}

void RealTimePilot::start() {
  for (const auto& [link, bus] : buses_) bus->start();
  boost::asio::co_spawn(io_, keep_time(), boost::asio::detached);
}

void RealTimePilot::stop() {
  stopped_ = true;
  for (const auto& [link, bus] : buses_) bus->stop();
  clock_->notify();
}

boost::asio::awaitable<void> RealTimePilot::keep_time() {
  while (!stopped_) {
    const Stamp now = link::steady_now();
    if (const auto due = pilot_.deadline(); due && *due <= now) pilot_.tick(now);
    co_await clock_->wait_until(pilot_.deadline(), now);
  }
}

void RealTimePilot::send(const std::string& link, const wire::CanFrame& frame) {
  if (const auto bus = buses_.find(link); bus != buses_.end()) bus->second->send(frame);
}

}  // namespace drydock::pilot
