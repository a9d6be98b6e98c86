#include "hil/emulate/sampling_device.hpp"

namespace drydock::emulate {

sensor::ErrorModel DeviceSetup::primary_errors() const {
  return {config.emulate.primary, config.emulate.fixed_bias, seed, config.name, "primary"};
}

sensor::ErrorModel DeviceSetup::secondary_errors() const {
  return {config.emulate.secondary, config.emulate.fixed_bias, seed, config.name, "secondary"};
}

wire::cia404_pressure::Scale DeviceSetup::pressure_scale() const {
  const auto& pressure = config.pressure;
  return wire::cia404_pressure::find_scale(pressure.format, pressure.unit,
                                           static_cast<unsigned>(pressure.decimals))
      .value();
}

SamplingDevice::SamplingDevice(const DeviceSetup& setup)
    : trajectory_(setup.trajectory),
      mounting_(sensor::mounting_of(setup.config)),
      rate_hz_(setup.config.rate_hz),
      latency_(measurement::from_seconds(setup.config.emulate.latency_s)),
      first_(setup.trajectory.start()) {}

void SamplingDevice::sample_at_whole_multiples() {
  const std::int64_t period = measurement::from_seconds(1 / rate_hz_).count();
  const std::int64_t start = first_.time_since_epoch().count();
  first_ = measurement::stamp_from_ns((start + period - 1) / period * period);
}

Stamp SamplingDevice::sample_time() const {
  return first_ + measurement::from_seconds(static_cast<double>(samples_) / rate_hz_);
}

void SamplingDevice::tick(Stamp now, Wire& out) {
  while (send_time() <= now) {
    sample(sample_time(), out);
    ++samples_;
  }
}

}  // namespace drydock::emulate
