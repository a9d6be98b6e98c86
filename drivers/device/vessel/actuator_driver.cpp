#include "drivers/device/vessel/actuator_driver.hpp"

#include <cmath>
#include <numbers>

namespace drydock::device {

namespace {
/// A frame takes 0.6 ms at 250 kbit/s: no other frame fits into this pause.
constexpr std::chrono::microseconds pause_between_bursts{500};
}  // namespace

ActuatorDriver::ActuatorDriver(const DriverOptions& options)
    : Nmea2000Driver(options),
      surface_source_{SourceFilter{options.address}, SourceFilter{options.address},
                      SourceFilter{options.address}},
      engine_source_(options.address),
      engine_instance_("engine", options.instance),
      burst_(pause_between_bursts) {}

void ActuatorDriver::receive(const wire::CanFrame& frame, Stamp received_at, Output& out) {
  const auto message = decoder_.receive(frame, received_at.time_since_epoch());
  if (!message) return;
  if (const auto* rudder = std::get_if<wire::nmea2000::Rudder>(&*message)) {
    const std::size_t kind = 1 + rudder->instance.value_or(surfaces);
    on(*rudder, in_burst(frame, received_at, rudder->source, kind), out);
  } else if (const auto* engine = std::get_if<wire::nmea2000::Engine>(&*message)) {
    on(*engine, in_burst(frame, received_at, engine->source, 0), out);
  } else if (const auto* claim = std::get_if<wire::j1939::AddressClaimed>(&*message)) {
    for (SourceFilter& source : surface_source_)
      source.claimed(claim->source, claim->name, received_at);
    engine_source_.claimed(claim->source, claim->name, received_at);
  }
}

Origin ActuatorDriver::in_burst(const wire::CanFrame& frame, Stamp received_at, std::uint8_t source,
                                std::size_t kind) {
  if (source != burst_source_) burst_.end();
  burst_source_ = source;
  return burst_.of(timing_.of_frame(received_at, frame), timing_.line_time(frame), kind);
}

void ActuatorDriver::on(const wire::nmea2000::Rudder& rudder, const Origin& origin, Output& out) {
  if (rudder.angle_order_rad && !rudder.position_rad) return;  // an order of whoever steers
  if (!rudder.instance || *rudder.instance >= surfaces)
    return out.refuse("a rudder instance other than 0, 1 and 2 was left out: it is no actuator",
                      Refusal::of_another);
  if (!accepts(surface_source_[*rudder.instance], rudder.source, origin.received_at)) return;
  if (std::abs(rudder.position_rad.value_or(0)) > std::numbers::pi / 2)
    return out.refuse("a surface beyond 90 degrees was dropped: damaged on its way");
  measurement::ActuatorState state;
  state.origin = origin;
  if (*rudder.instance == 0 && rudder.position_rad) state.rudder_rad = -*rudder.position_rad;
  if (*rudder.instance == 1) state.stern_plane_rad = rudder.position_rad;
  if (*rudder.instance == 2) state.bow_plane_rad = rudder.position_rad;
  out.publish(state);
}

void ActuatorDriver::on(const wire::nmea2000::Engine& engine, const Origin& origin, Output& out) {
  if (!accepts(engine_source_, engine.source, origin.received_at)) return;
  if (!engine_instance_.accepts(engine.instance, origin.received_at, out)) return;
  measurement::ActuatorState state;
  state.origin = origin;
  state.propeller_radps = engine.speed_radps;
  out.publish(state);
}

}  // namespace drydock::device
