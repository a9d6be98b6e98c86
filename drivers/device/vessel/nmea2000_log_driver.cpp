#include "drivers/device/vessel/nmea2000_log_driver.hpp"

namespace drydock::device {

namespace {
/// A frame takes 0.6 ms at 250 kbit/s: no other frame fits into this pause.
constexpr std::chrono::microseconds pause_between_logs{500};
}  // namespace

Nmea2000LogDriver::Nmea2000LogDriver(const DriverOptions& options)
    : Nmea2000Driver(options),
      axes_(options),
      source_(options.address),
      burst_(pause_between_logs) {}

void Nmea2000LogDriver::receive(const wire::CanFrame& frame, Stamp received_at, Output& out) {
  const Origin origin = in_burst(frame, received_at);
  const auto message = decoder_.receive(frame, received_at.time_since_epoch());
  if (!message) return;
  std::visit(
      [&](const auto& m) {
        if constexpr (requires { on(m, origin, out); }) on(m, origin, out);
      },
      *message);
}

Origin Nmea2000LogDriver::in_burst(const wire::CanFrame& frame, Stamp received_at) {
  const Origin alone = timing_.of_frame(received_at, frame);
  const auto id = wire::j1939::identify(frame);
  const bool is_speed = id && id->pgn == wire::nmea2000::Speed::pgn;
  const bool is_distance = id && id->pgn == wire::nmea2000::DistanceLog::pgn;
  if (!is_speed && !is_distance) return alone;
  if (id->source != burst_source_) burst_.end();
  burst_source_ = id->source;
  const auto on_wire = timing_.line_time(frame);
  const bool is_further_part = is_distance && !wire::begins_fast_packet(frame.payload());
  return is_further_part ? burst_.of_part(alone, on_wire) : burst_.of(alone, on_wire, is_speed);
}

void Nmea2000LogDriver::on(const wire::nmea2000::Speed& speed, const Origin& origin, Output& out) {
  if (!accepts(source_, speed.source, origin.received_at)) return;
  auto along_mps = speed.water_mps;
  if (along_mps && speed.direction == wire::nmea2000::Speed::reverse) along_mps = -*along_mps;
  axes_.publish(along_mps, {}, origin, out);
}

void Nmea2000LogDriver::on(const wire::nmea2000::DistanceLog& log, const Origin& origin,
                           Output& out) {
  if (!accepts(source_, log.source, origin.received_at) || !log.total_m) return;
  measurement::WaterSpeed result;
  result.origin = origin;
  result.distance_m = axes_.way(log.total_m);
  out.publish(result);
}

void Nmea2000LogDriver::on(const wire::j1939::AddressClaimed& claim, const Origin& origin,
                           Output&) {
  source_.claimed(claim.source, claim.name, origin.received_at);
}

}  // namespace drydock::device
