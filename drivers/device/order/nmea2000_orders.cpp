#include "drivers/device/order/nmea2000_orders.hpp"

#include "drivers/wire/nmea2000/actuator_messages.hpp"

namespace drydock::device {

namespace {

// NMEA 2000 class "steering and control surfaces", function "autopilot".
constexpr std::uint8_t device_class = 40, autopilot = 150;
constexpr std::uint8_t marine = 4;

std::uint64_t name_of_pilot() {
  wire::j1939::Name name;
  name.function = autopilot;
  name.vehicle_system = device_class;
  name.industry_group = marine;
  name.arbitrary_address_capable = true;
  return to_value(name);
}

void send(const std::optional<wire::CanFrame>& frame, Output& out) {
  if (frame) out.send(*frame);
}

}  // namespace

Nmea2000Orders::Nmea2000Orders(std::array<bool, measurement::actuator_count> moves,
                               std::uint8_t engine_instance, std::uint8_t preferred_address)
    : moves_(moves),
      engine_instance_(engine_instance),
      claim_(name_of_pilot(), preferred_address) {}

void Nmea2000Orders::restart(Stamp now, Output& out) {
  send(claim_.start(now.time_since_epoch()), out);
}

void Nmea2000Orders::order(const measurement::ActuatorOrder& order, Stamp, Output& out) {
  const auto address = claim_.address();
  if (!address) return;
  for (int number = 0; number < measurement::propeller_number; ++number) {
    const auto& angle = value_of(order, number);
    if (!angle || !moves_.at(static_cast<std::size_t>(number))) continue;
    wire::nmea2000::Rudder rudder;
    rudder.source = *address;
    rudder.instance = static_cast<std::uint8_t>(number);
    rudder.direction_order = 0;
    rudder.angle_order_rad = number == 0 ? -*angle : *angle;  // on the wire starboard is positive
    out.send(encode(rudder));
  }
  if (!order.propeller_radps || !moves_[measurement::propeller_number]) return;
  wire::nmea2000::Engine engine;
  engine.source = *address;
  engine.instance = engine_instance_;
  engine.speed_radps = order.propeller_radps;
  out.send(encode(engine));
}

void Nmea2000Orders::receive(const wire::CanFrame& frame, Stamp now, Output& out) {
  send(claim_.receive(frame, now.time_since_epoch()), out);
}

void Nmea2000Orders::tick(Stamp now, Output& out) {
  send(claim_.tick(now.time_since_epoch()), out);
}

std::optional<Stamp> Nmea2000Orders::deadline() const {
  if (const auto due = claim_.deadline()) return Stamp{*due};
  return {};
}

}  // namespace drydock::device
