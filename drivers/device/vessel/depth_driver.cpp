#include "drivers/device/vessel/depth_driver.hpp"

#include "drivers/device/vessel/depth_gate.hpp"

namespace drydock::device {

namespace {
constexpr std::chrono::seconds temperature_counts_for{10};  // PGN 130312 comes every 2 s
constexpr std::chrono::milliseconds tied_for{100};          // a SID repeats after 253 samples
}  // namespace

DepthDriver::DepthDriver(const DriverOptions& options)
    : Nmea2000Driver(options),
      water_(options.water),
      pressure_source_(options.address),
      temperature_source_(options.address),
      sounder_source_(options.address),
      pressure_instance_("pressure", options.instance),
      temperature_instance_("sea temperature", std::nullopt) {}

void DepthDriver::receive(const wire::CanFrame& frame, Stamp received_at, Output& out) {
  const auto message = decoder_.receive(frame, received_at.time_since_epoch());
  if (!message) return;
  const Origin origin = timing_.of_frame(received_at, frame);
  std::visit(
      [&](const auto& m) {
        if constexpr (requires { on(m, origin, out); }) on(m, origin, out);
      },
      *message);
}

void DepthDriver::on(const wire::nmea2000::Pressure& pressure, const Origin& origin, Output& out) {
  if (pressure.kind != wire::nmea2000::Pressure::water) return;
  if (!accepts(pressure_source_, pressure.source, origin.received_at)) return;
  if (!pressure_instance_.accepts(pressure.instance, origin.received_at, out)) return;
  measurement::DepthSample sample;
  sample.origin = origin;
  sample.pressure_pa = pressure.pressure_pa;
  if (pressure.pressure_pa) sample.depth_m = water_.depth_m(*pressure.pressure_pa);
  if (origin.received_at - temperature_at_ < temperature_counts_for) {
    sample.temperature_k = temperature_k_;
  }
  if (!is_possible(sample, out)) return;
  last_pressure_ = {pressure.source, pressure.sequence, origin};
  out.publish(sample);
}

void DepthDriver::on(const wire::nmea2000::Temperature& temperature, const Origin& origin,
                     Output& out) {
  if (temperature.kind != wire::nmea2000::Temperature::sea) return;
  if (!accepts(temperature_source_, temperature.source, origin.received_at)) return;
  if (!temperature_instance_.accepts(temperature.instance, origin.received_at, out)) return;
  temperature_k_ = temperature.actual_k;
  temperature_at_ = origin.received_at;
}

void DepthDriver::on(const wire::nmea2000::WaterDepth& depth, const Origin& origin, Output& out) {
  if (!accepts(sounder_source_, depth.source, origin.received_at)) return;
  measurement::DepthSample sample;
  sample.origin = origin;
  if (depth.sequence && depth.sequence == last_pressure_.sequence &&
      depth.source == last_pressure_.source &&
      origin.received_at - last_pressure_.origin.received_at < tied_for) {
    sample.origin.valid_at = last_pressure_.origin.valid_at;
  }
  sample.altitude_m = depth.depth_m;
  if (is_possible(sample, out)) out.publish(sample);
}

void DepthDriver::on(const wire::j1939::AddressClaimed& claim, const Origin& origin, Output&) {
  for (SourceFilter* source : {&pressure_source_, &temperature_source_, &sounder_source_})
    source->claimed(claim.source, claim.name, origin.received_at);
}

}  // namespace drydock::device
