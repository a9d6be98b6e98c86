#include "drivers/host/driver_host.hpp"

#include <fmt/format.h>

#include <utility>

#include "drivers/host/rig_bus.hpp"
#include "drivers/link/link.hpp"

namespace drydock::host {

namespace {
constexpr std::chrono::seconds health_period{1}, longest_lag{1};
}

DriverHost::DriverHost(boost::asio::io_context& io,
                       std::vector<std::unique_ptr<device::Device>> devices, Follower& follower)
    : follower_(follower),
      wakes_(io, follower),
      shell_(io, std::move(devices), *this, this),
      health_timer_(io) {}

void DriverHost::start() {
  wakes_.start();
  shell_.start();
  health_timer_.expires_after(health_period);
  schedule_health();
}

void DriverHost::stop() {
  if (std::exchange(stopped_, true)) return;
  health_timer_.cancel();
  wakes_.stop();
  shell_.stop();
}

std::vector<const device::Device*> DriverHost::devices() const {
  std::vector<const device::Device*> all;
  for (std::size_t i = 0; i < shell_.size(); ++i) all.push_back(&shell_.device(i));
  return all;
}

bool DriverHost::all_streaming() const {
  for (std::size_t i = 0; i < shell_.size(); ++i) {
    if (shell_.device(i).state() != device::State::streaming) return false;
  }
  return true;
}

void DriverHost::schedule_health() {
  health_timer_.async_wait([this](const boost::system::error_code& ec) {
    if (ec || stopped_) return;
    tell_health();
    note_stall();
    health_timer_.expires_at(health_timer_.expiry() + health_period);
    schedule_health();
  });
}

/// Bytes and frames that waited in the system meanwhile have the times at which they were read.
void DriverHost::note_stall() {
  const auto lag = std::chrono::steady_clock::now() - health_timer_.expiry();
  if (lag < longest_lag) return;
  fmt::print(stderr, "this program stood still for {:.1f} s: what came meanwhile has late times\n",
             std::chrono::duration<double>(lag).count());
  health_timer_.expires_at(std::chrono::steady_clock::now());
}

void DriverHost::tell_health() {
  const auto now = link::now();
  const HealthReport health([this, now] {
    HealthReport::Statuses statuses;
    for (std::size_t i = 0; i < shell_.size(); ++i)
      statuses.push_back(status_of(shell_.device(i), shell_.device(i).health(now)));
    return statuses;
  });
  follower_.on_health(health, now);
}

}  // namespace drydock::host
