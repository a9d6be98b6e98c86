#include "hil/pilot/order_ports.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>

#include "drivers/device/order/canopen_orders.hpp"
#include "drivers/device/order/nmea2000_orders.hpp"
#include "drivers/measurement/earlier.hpp"
#include "drivers/wire/canopen/cia402.hpp"
#include "drivers/wire/nmea2000/nmea2000.hpp"

namespace drydock::pilot {

namespace {

using rig_config::DeviceConfig;
using rig_config::DeviceKind;

constexpr std::uint8_t preferred_address = 0x20;

bool speaks(const DeviceConfig& device, std::string_view protocol) {
  return device.kind == DeviceKind::actuator && device.protocol == protocol;
}

/// The actuators of the rig that no drive moves.
std::array<bool, measurement::actuator_count> without_a_drive(const rig_config::Rig& rig) {
  std::array<bool, measurement::actuator_count> left;
  left.fill(true);
  for (const DeviceConfig& device : rig.devices)
    if (speaks(device, wire::Cia402::name))
      left.at(static_cast<std::size_t>(device.instance.value_or(0))) = false;
  return left;
}

std::vector<device::CanopenOrders::Drive> drives_on(const rig_config::Rig& rig,
                                                    const std::string& link) {
  std::vector<device::CanopenOrders::Drive> drives;
  for (const DeviceConfig& device : rig.devices) {
    if (device.link != link || !speaks(device, wire::Cia402::name)) continue;
    const auto patience = measurement::from_seconds(device.heartbeat_timeout_s);
    drives.push_back({static_cast<std::uint8_t>(device.address), device.instance.value_or(0),
                      std::chrono::duration_cast<std::chrono::milliseconds>(patience)});
  }
  return drives;
}

}  // namespace

/// One sender and the bus on which it speaks.
class OrderPorts::Port final : private device::Output {
 public:
  Port(std::string on, std::unique_ptr<device::OrderSender> by, const Send& to, const Say& tell)
      : link(std::move(on)), sender_(std::move(by)), send_(to), say_(tell) {}

  void restart(Stamp now) { sender_->restart(now, *this); }
  void order(const measurement::ActuatorOrder& order, Stamp now) {
    sender_->order(order, now, *this);
  }
  void receive(const wire::CanFrame& frame, Stamp now) { sender_->receive(frame, now, *this); }
  void tick(Stamp now) { sender_->tick(now, *this); }
  std::optional<Stamp> deadline() const { return sender_->deadline(); }

  std::string link;

 private:
  void publish(const device::Measurement&) override {}
  void send(std::span<const std::uint8_t>) override {}
  void send(const wire::CanFrame& frame) override { send_(link, frame); }
  void report(std::string_view trouble) override {
    if (told_.emplace(trouble).second) say_(fmt::format("{}: {}", link, trouble));
  }

  std::unique_ptr<device::OrderSender> sender_;
  Send send_;
  Say say_;
  std::set<std::string, std::less<>> told_;
};

OrderPorts::OrderPorts(const rig_config::Rig& rig, const Send& send, const Say& say) {
  const auto left = without_a_drive(rig);
  std::set<std::string> canopen;
  for (const DeviceConfig& device : rig.devices) {
    if (speaks(device, wire::Cia402::name) && canopen.insert(device.link).second)
      ports_.push_back(std::make_unique<Port>(
          device.link, std::make_unique<device::CanopenOrders>(drives_on(rig, device.link)), send,
          say));
    if (speaks(device, wire::Nmea2000::name))
      ports_.push_back(std::make_unique<Port>(
          device.link,
          std::make_unique<device::Nmea2000Orders>(
              left, static_cast<std::uint8_t>(device.instance.value_or(0)), preferred_address),
          send, say));
  }
  if (ports_.empty())
    throw std::runtime_error(
        "nothing takes the orders of the mission's autopilot; allowed: devices of kind actuator "
        "with "
        "nmea2000 or cia402");
}

OrderPorts::~OrderPorts() = default;

std::vector<std::string> OrderPorts::links() const {
  std::set<std::string> links;
  for (const auto& port : ports_) links.insert(port->link);
  return {links.begin(), links.end()};
}

void OrderPorts::restart(const std::string& link, Stamp now) {
  for (const auto& port : ports_)
    if (port->link == link) port->restart(now);
}

void OrderPorts::order(const measurement::ActuatorOrder& order, Stamp now) {
  for (const auto& port : ports_) port->order(order, now);
}

void OrderPorts::receive(const std::string& link, const wire::CanFrame& frame, Stamp now) {
  for (const auto& port : ports_)
    if (port->link == link) port->receive(frame, now);
}

void OrderPorts::tick(Stamp now) {
  for (const auto& port : ports_)
    if (const auto due = port->deadline(); due && *due <= now) port->tick(now);
}

std::optional<Stamp> OrderPorts::deadline() const {
  std::optional<Stamp> next;
  for (const auto& port : ports_) next = measurement::earlier(next, port->deadline());
  return next;
}

}  // namespace drydock::pilot
