#include "hil/emulate/sampling_device.hpp"

namespace drydock::emulate {
namespace {

struct NoWire final : Wire {
  void send(wire::Bytes) override {}
  void send(const wire::CanFrame&) override {}
};

}  // namespace

sensor::ErrorModel DeviceSetup::primary_errors() const {
  return {config.emulate.primary,
          config.rate_hz,
          {seed, config.name, "primary", config.emulate.fixed_bias, &condition->primary}};
}

sensor::ErrorModel DeviceSetup::secondary_errors() const {
  return {config.emulate.secondary,
          config.rate_hz,
          {seed, config.name, "secondary", config.emulate.fixed_bias, &condition->secondary}};
}

sensor::ImuErrors DeviceSetup::imu_errors() const {
  return {config.emulate,
          config.rate_hz,
          seed,
          config.name,
          {&condition->primary, &condition->secondary}};
}

sensor::ImuSampler DeviceSetup::imu_sampler() const {
  return {trajectory, sensor::mounting_of(config), config.rate_hz, config.means};
}

wire::cia404_pressure::Scale DeviceSetup::pressure_scale() const {
  const auto& pressure = config.pressure;
  return wire::cia404_pressure::find_scale(pressure.format, pressure.unit,
                                           static_cast<unsigned>(pressure.decimals))
      .value();
}

namespace {

/// A DVL that is set to turn its velocities by an angle stands at that angle in the vehicle.
sensor::Mounting standing(const rig_config::DeviceConfig& config) {
  auto mounting = sensor::mounting_of(config);
  const auto& settings = config.water_linked;
  const double turned_rad = settings ? settings->mounting_rotation_rad.value_or(0) : 0;
  mounting.sensor_to_body *=
      Eigen::AngleAxisd(turned_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return mounting;
}

}  // namespace

SamplingDevice::SamplingDevice(const DeviceSetup& setup)
    : trajectory_(setup.trajectory),
      mounting_(standing(setup.config)),
      rate_hz_(setup.config.rate_hz),
      latency_(measurement::from_seconds(setup.config.emulate.latency_s)),
      dropouts_(setup.config.emulate.dropout, setup.seed, setup.config.name),
      condition_(setup.condition),
      first_(setup.boot) {}

void SamplingDevice::sample_at_whole_multiples() {
  const std::int64_t period = measurement::from_seconds(1 / rate_hz_).count();
  const std::int64_t start = first_.time_since_epoch().count();
  first_ = measurement::stamp_from_ns((start + period - 1) / period * period);
}

void SamplingDevice::go_on_at(double rate_hz) {
  const auto taken = static_cast<double>(samples_);
  first_ +=
      measurement::from_seconds(taken / rate_hz_) - measurement::from_seconds(taken / rate_hz);
  rate_hz_ = rate_hz;
}

void SamplingDevice::go_on_at_whole_multiples(double rate_hz, Stamp now) {
  rate_hz_ = rate_hz;
  first_ = now;
  sample_at_whole_multiples();
  first_ += ahead_ - measurement::from_seconds(static_cast<double>(samples_) / rate_hz_);
}

Stamp SamplingDevice::sample_time() const {
  return first_ + measurement::from_seconds(static_cast<double>(samples_) / rate_hz_) - ahead_;
}

void SamplingDevice::tick(Stamp now, Wire& out) {
  while (send_time() <= now) {
    take(sample_time(), out);
    ++samples_;
    ahead_ += measurement::from_seconds(condition_->clock.rate / rate_hz_);
  }
}

/// One of `times_fewer` samples is sent.
bool SamplingDevice::is_left_out() {
  to_leave_out_ += 1 / condition_->times_fewer;
  if (to_leave_out_ < 1) return true;
  to_leave_out_ -= 1;
  return false;
}

void SamplingDevice::take(Stamp at, Wire& out) {
  NoWire nowhere;
  under_way_ = at;
  lost_ = dropouts_.next_is_lost() || is_left_out();
  sample(at, lost_ ? static_cast<Wire&>(nowhere) : out);
  under_way_.reset();
}

}  // namespace drydock::emulate
