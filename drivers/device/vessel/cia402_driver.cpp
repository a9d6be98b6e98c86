#include "drivers/device/vessel/cia402_driver.hpp"

#include <cmath>
#include <numbers>

#include "drivers/measurement/actuator_order.hpp"

namespace drydock::device {

namespace cia402 = wire::cia402;
namespace canopen = wire::canopen;

namespace {

using canopen::Pdo;

constexpr Pdo by_position(canopen::tpdo_id(1, 0), {0x60410010, 0x60640020}),
    by_velocity(canopen::tpdo_id(1, 0), {0x60410010, 0x606C0020});

const Pdo& usual_of(int actuator) {
  return actuator >= measurement::propeller_number ? by_velocity : by_position;
}

}  // namespace

Cia402Driver::Cia402Driver(const DriverOptions& options)
    : BusDriver(options),
      node_(options, {&usual_of(options.instance.value_or(0)), 1}),
      actuator_(options.instance.value_or(0)) {}

void Cia402Driver::receive(const wire::CanFrame& frame, Stamp received_at, Output& out) {
  for (const wire::CanFrame& usual : node_.frames_of(frame, received_at, out))
    decode(usual, received_at, out);
}

void Cia402Driver::decode(const wire::CanFrame& frame, Stamp received_at, Output& out) {
  const auto message = decoder_.receive(frame);
  if (!message) return;
  if (const auto* status = std::get_if<cia402::DriveStatus>(&*message)) {
    on(*status, timing_.of_frame(received_at, frame), out);
  } else if (const auto* heartbeat = std::get_if<canopen::Heartbeat>(&*message)) {
    node_.on(*heartbeat, received_at, out);
  } else if (const auto* emergency = std::get_if<canopen::Emergency>(&*message)) {
    node_.on(*emergency, out);
  }
}

void Cia402Driver::on(const cia402::DriveStatus& status, const Origin& origin, Output& out) {
  if (!node_.accepts(status.node, origin.received_at)) return;
  const auto state = cia402::state_of(status.status_word);
  if (state == cia402::DriveState::fault && state_ != state) out.report("the drive is in fault");
  state_ = state;
  const double value = status.actual * cia402::radians_per_increment;
  if (actuator_ < measurement::propeller_number && std::abs(value) > std::numbers::pi / 2)
    return out.refuse("a surface beyond 90 degrees was dropped: damaged on its way");
  measurement::ActuatorState measured;
  measured.origin = origin;
  value_of(measured, actuator_) = value;
  out.publish(measured);
}

}  // namespace drydock::device
