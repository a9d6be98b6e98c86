#include "drivers/device/vessel/cia404_pressure_driver.hpp"

#include "drivers/device/vessel/depth_gate.hpp"

namespace drydock::device {

namespace canopen = wire::canopen;

namespace {

using canopen::Pdo;
using wire::cia404_pressure::Form;

constexpr std::uint32_t integer = 0x91300120, status = 0x61500108, real = 0x61300120;
constexpr Pdo with_status(canopen::tpdo_id(1, 0), {integer, status}),
    integer_alone(canopen::tpdo_id(1, 0), {integer}), real_alone(canopen::tpdo_id(1, 0), {real});

const Pdo& usual_in(Form form) {
  switch (form) {
    case Form::integer_and_status: return with_status;
    case Form::integer: return integer_alone;
    case Form::real32: return real_alone;
  }
  return with_status;
}

}  // namespace

Cia404PressureDriver::Cia404PressureDriver(const DriverOptions& options)
    : BusDriver(options),
      node_(options, {&usual_in(options.pressure.scale.form), 1}, LongerPdos::read),
      scale_(options.pressure.scale),
      zero_pa_(options.pressure.gauge ? options.water.surface_pressure_pa : 0),
      water_(options.water) {}

void Cia404PressureDriver::receive(const wire::CanFrame& frame, Stamp received_at, Output& out) {
  for (const wire::CanFrame& usual : node_.frames_of(frame, received_at, out))
    decode(usual, received_at, out);
}

void Cia404PressureDriver::decode(const wire::CanFrame& frame, Stamp received_at, Output& out) {
  const auto message = decoder_.receive(frame);
  if (!message) return;
  if (const auto* value = std::get_if<wire::cia404_pressure::ProcessValue>(&*message)) {
    on(*value, timing_.of_frame(received_at, frame), out);
  } else if (const auto* heartbeat = std::get_if<canopen::Heartbeat>(&*message)) {
    node_.on(*heartbeat, received_at, out);
  } else if (const auto* emergency = std::get_if<canopen::Emergency>(&*message)) {
    node_.on(*emergency, out);
  }
}

void Cia404PressureDriver::on(const wire::cia404_pressure::ProcessValue& value,
                              const Origin& origin, Output& out) {
  if (!node_.accepts(value.node, origin.received_at)) return;
  measurement::DepthSample sample;
  sample.origin = origin;
  if (const auto reading = wire::cia404_pressure::pressure_pa(value, scale_)) {
    sample.pressure_pa = *reading + zero_pa_;
    sample.depth_m = water_.depth_m(*sample.pressure_pa);
  }
  if (is_possible(sample, out)) out.publish(sample);
}

}  // namespace drydock::device
