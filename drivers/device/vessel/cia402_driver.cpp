#include "drivers/device/vessel/cia402_driver.hpp"

#include <cmath>
#include <numbers>

#include "drivers/measurement/actuator_order.hpp"

namespace drydock::device {

namespace cia402 = wire::cia402;
namespace canopen = wire::canopen;

Cia402Driver::Cia402Driver(const DriverOptions& options)
    : BusDriver(options), node_(options), actuator_(options.instance.value_or(0)) {}

void Cia402Driver::receive(const wire::CanFrame& frame, Stamp received_at, Output& out) {
  if (node_.is_of_another(frame)) return;
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
