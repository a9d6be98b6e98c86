#include "drivers/device/imu/mv5_imu_driver.hpp"

namespace drydock::device {

namespace {

/// From SAE's order: lateral, longitudinal, vertical.
ImuComponents to_xyz(const ImuComponents& sae) { return {sae[1], sae[0], sae[2]}; }

}  // namespace

Mv5ImuDriver::Mv5ImuDriver(const DriverOptions& options)
    : BusDriver(options), source_(options.address), pair_(options.mounting) {}

void Mv5ImuDriver::restart(Stamp now, Output& out) {
  pair_.reset();
  search_.restart(now, out);
}

bool Mv5ImuDriver::accepts(std::uint8_t source, Stamp at) {
  if (!source_.accepts(source, at)) return false;
  search_.heard(at);
  return true;
}

void Mv5ImuDriver::receive(const wire::CanFrame& frame, Stamp received_at, Output& out) {
  const auto message = decoder_.receive(frame);
  if (!message) return;
  std::visit(
      [&](const auto& m) {
        if constexpr (requires { on(m, frame, received_at, out); }) on(m, frame, received_at, out);
      },
      *message);
}

void Mv5ImuDriver::on(const wire::mv5::AngularRate& m, const wire::CanFrame& frame, Stamp at,
                      Output& out) {
  if (!accepts(m.source, at)) return;
  pair_.add_rate(half_of(timing_, frame, at, to_xyz(m.rate_radps), m.latency_s), out);
}

void Mv5ImuDriver::on(const wire::mv5::Acceleration& m, const wire::CanFrame& frame, Stamp at,
                      Output& out) {
  if (!accepts(m.source, at)) return;
  pair_.add_force(half_of(timing_, frame, at, to_xyz(m.acceleration_mps2)), out);
}

void Mv5ImuDriver::on(const wire::j1939::AddressClaimed& m, const wire::CanFrame&, Stamp at,
                      Output&) {
  source_.claimed(m.source, m.name, at);
}

}  // namespace drydock::device
