#include "drivers/device/imu/mv5_imu_driver.hpp"

namespace drydock::device {

namespace {

/// From SAE's order: lateral, longitudinal, vertical.
ImuPair::Components to_xyz(const ImuPair::Components& sae) { return {sae[1], sae[0], sae[2]}; }

}  // namespace

Mv5ImuDriver::Mv5ImuDriver(const DriverOptions& options)
    : BusDriver(options), mounting_(options.mounting), source_(options.address) {}

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
  pair_.set_rate(timing_.of_frame(at, frame), to_xyz(m.rate_radps));
  if (m.latency_s) {
    pair_.state(timing_.of_frame(at, frame, measurement::from_seconds(*m.latency_s)).valid_at);
  }
  pair_.publish(mounting_, out);
}

void Mv5ImuDriver::on(const wire::mv5::Acceleration& m, const wire::CanFrame& frame, Stamp at,
                      Output& out) {
  if (!accepts(m.source, at)) return;
  pair_.set_force(timing_.of_frame(at, frame), to_xyz(m.acceleration_mps2));
  pair_.publish(mounting_, out);
}

void Mv5ImuDriver::on(const wire::j1939::AddressClaimed& m, const wire::CanFrame&, Stamp at,
                      Output&) {
  source_.claimed(m.source, m.name, at);
}

}  // namespace drydock::device
