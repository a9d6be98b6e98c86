#include "drivers/device/vessel/nmea2000_attitude_driver.hpp"

#include "drivers/device/vessel/attitude_gate.hpp"

namespace drydock::device {

namespace {

/// A frame takes 0.6 ms at 250 kbit/s: no other frame fits into this pause.
constexpr std::chrono::microseconds pause_between_attitudes{500};

measurement::HeadingReference reference_of(const std::optional<std::uint8_t>& code) {
  using enum measurement::HeadingReference;
  if (code == wire::nmea2000::true_north) return true_north;
  return code == wire::nmea2000::magnetic_north ? magnetic_north : unknown;
}

}  // namespace

Nmea2000AttitudeDriver::Nmea2000AttitudeDriver(const DriverOptions& options)
    : Nmea2000Driver(options),
      axes_(options),
      source_(options.address),
      burst_(pause_between_attitudes) {}

void Nmea2000AttitudeDriver::receive(const wire::CanFrame& frame, Stamp received_at, Output& out) {
  const auto message = decoder_.receive(frame, received_at.time_since_epoch());
  if (!message) return;
  std::visit(
      [&](const auto& m) {
        if constexpr (requires { on(m, Origin{}, out); })
          on(m, in_burst(frame, received_at, message->index()), out);
      },
      *message);
}

Origin Nmea2000AttitudeDriver::in_burst(const wire::CanFrame& frame, Stamp received_at,
                                        std::size_t kind) {
  const auto id = wire::j1939::identify(frame);
  if (id->source != burst_source_) burst_.end();
  burst_source_ = id->source;
  return burst_.of(timing_.of_frame(received_at, frame), timing_.line_time(frame), kind);
}

void Nmea2000AttitudeDriver::on(const wire::nmea2000::VesselHeading& heading, const Origin& origin,
                                Output& out) {
  if (!accepts(source_, heading.source, origin.received_at)) return;
  if (!is_possible_heading(heading.heading_rad, heading.deviation_rad, heading.variation_rad, out))
    return;
  measurement::AttitudeSample result;
  result.origin = origin;
  result.reference = reference_of(heading.reference);
  result.deviation_rad = heading.deviation_rad;
  result.variation_rad = heading.variation_rad ? heading.variation_rad : variation_rad_;
  if (heading.heading_rad) axes_.heading(*heading.heading_rad, result);
  out.publish(result);
}

void Nmea2000AttitudeDriver::on(const wire::nmea2000::RateOfTurn& turn, const Origin& origin,
                                Output& out) {
  if (!accepts(source_, turn.source, origin.received_at)) return;
  if (!is_possible_turn(turn.rate_radps, out)) return;
  measurement::AttitudeSample result;
  result.origin = origin;
  result.rate_of_turn_radps = turn.rate_radps;
  out.publish(result);
}

void Nmea2000AttitudeDriver::on(const wire::nmea2000::Attitude& attitude, const Origin& origin,
                                Output& out) {
  if (!accepts(source_, attitude.source, origin.received_at)) return;
  if (!is_possible_tilt(attitude.roll_rad, attitude.pitch_rad, out)) return;
  measurement::AttitudeSample result;
  result.origin = origin;
  axes_.tilt(attitude.roll_rad, attitude.pitch_rad, result, out);
  out.publish(result);
}

void Nmea2000AttitudeDriver::on(const wire::nmea2000::MagneticVariation& variation,
                                const Origin& origin, Output& out) {
  if (!variation_source_.accepts(variation.source, origin.received_at)) return;
  if (is_beyond(variation.variation_rad, std::numbers::pi))
    return out.refuse("a variation beyond 180 degrees was dropped: damaged on its way");
  if (variation.variation_rad) variation_rad_ = variation.variation_rad;
}

void Nmea2000AttitudeDriver::on(const wire::j1939::AddressClaimed& claim, const Origin& origin,
                                Output&) {
  source_.claimed(claim.source, claim.name, origin.received_at);
  variation_source_.claimed(claim.source, claim.name, origin.received_at);
}

}  // namespace drydock::device
