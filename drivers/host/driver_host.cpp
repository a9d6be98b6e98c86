#include "drivers/host/driver_host.hpp"

#include <utility>

#include "drivers/host/rig_bus.hpp"
#include "drivers/link/link.hpp"

namespace drydock::host {

namespace {
constexpr std::chrono::seconds health_period{1};
}

DriverHost::DriverHost(boost::asio::io_context& io,
                       std::vector<std::unique_ptr<device::Device>> devices, bus::Publisher* bus,
                       shell::RawListener* raw)
    : bus_(bus), shell_(io, std::move(devices), *this, raw), health_timer_(io) {}

void DriverHost::start() {
  shell_.start();
  health_timer_.expires_after(health_period);
  schedule_health();
}

void DriverHost::stop() {
  if (std::exchange(stopped_, true)) return;
  health_timer_.cancel();
  shell_.stop();
}

bool DriverHost::all_streaming() const {
  for (std::size_t i = 0; i < shell_.size(); ++i) {
    if (shell_.device(i).state() != device::State::streaming) return false;
  }
  return true;
}

void DriverHost::on_measurement(const measurement::Measurement& measurement) {
  if (bus_ != nullptr) bus_->publish(measurement);
  if (on_measurement_hook) on_measurement_hook(measurement);
}

void DriverHost::on_state(const device::Device& device, const device::Transition& change) {
  if (on_state_hook) on_state_hook(device, change);
}

void DriverHost::schedule_health() {
  health_timer_.async_wait([this](const boost::system::error_code& ec) {
    if (ec || stopped_) return;
    publish_health();
    health_timer_.expires_at(health_timer_.expiry() + health_period);
    schedule_health();
  });
}

void DriverHost::publish_health() {
  std::vector<bus::DeviceStatus> statuses;
  for (std::size_t i = 0; i < shell_.size(); ++i) {
    statuses.push_back(status_of(shell_.device(i), shell_.health(i)));
  }
  const auto now = link::now();
  if (bus_ != nullptr) bus_->publish(statuses, now);
  if (on_health_hook) on_health_hook(statuses, now);
}

}  // namespace drydock::host
