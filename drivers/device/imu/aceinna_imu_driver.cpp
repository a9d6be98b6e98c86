#include "drivers/device/imu/aceinna_imu_driver.hpp"

#include "drivers/measurement/earlier.hpp"

namespace drydock::device {

namespace {

namespace aceinna = wire::aceinna;

constexpr std::size_t place_of(const aceinna::HardwareBit&) { return 0; }
constexpr std::size_t place_of(const aceinna::SoftwareBit&) { return 1; }
constexpr std::size_t place_of(const aceinna::SensorStatus&) { return 2; }

}  // namespace

AceinnaImuDriver::AceinnaImuDriver(const DriverOptions& options)
    : BusDriver(options),
      source_(options.address),
      configurator_(options),
      pair_(options.mounting) {}

void AceinnaImuDriver::restart(Stamp now, Output& out) {
  pair_.reset();
  told_ = {};
  search_.restart(now, out);
  configurator_.restart(now, out);
}

void AceinnaImuDriver::tick(Stamp now, Output& out) {
  search_.tick(now, out);
  configurator_.tick(now, out);
}

std::optional<Stamp> AceinnaImuDriver::deadline() const {
  return measurement::earlier(search_.deadline(), configurator_.deadline());
}

bool AceinnaImuDriver::accepts(std::uint8_t source, Stamp at) {
  if (!source_.accepts(source, at)) return false;
  search_.heard(at);
  configurator_.found(source, at);
  return true;
}

void AceinnaImuDriver::receive(const wire::CanFrame& frame, Stamp received_at, Output& out) {
  configurator_.receive(frame, received_at, out);
  const auto message = decoder_.receive(frame);
  if (!message) return;
  std::visit(
      [&](const auto& m) {
        if constexpr (requires { on(m, frame, received_at, out); }) {
          on(m, frame, received_at, out);
        } else if constexpr (requires { m.source; }) {
          if (ours(m.source)) configurator_.on(*message, received_at);
        }
      },
      *message);
}

void AceinnaImuDriver::on(const aceinna::AngularRate& m, const wire::CanFrame& frame, Stamp at,
                          Output& out) {
  if (!accepts(m.source, at)) return;
  pair_.add_rate(half_of(timing_, frame, at, m.rate_radps, m.latency_s), out);
}

void AceinnaImuDriver::on(const aceinna::Acceleration& m, const wire::CanFrame& frame, Stamp at,
                          Output& out) {
  if (!accepts(m.source, at)) return;
  pair_.add_force(half_of(timing_, frame, at, m.acceleration_mps2), out);
}

/// The claim is the first message after a boot: the device has lost its settings.
void AceinnaImuDriver::on(const aceinna::AddressClaimed& m, const wire::CanFrame&, Stamp at,
                          Output&) {
  source_.claimed(m.source, aceinna::to_value(m.name), at);
  if (ours(m.source)) configurator_.begin_anew(at);
}

template <class Layout>
void AceinnaImuDriver::on(const aceinna::Flags<Layout>& m, const wire::CanFrame&, Stamp,
                          Output& out) {
  if (!ours(m.source)) return;
  std::string_view& told = told_[place_of(m)];
  const std::string_view trouble = m.trouble();
  if (!trouble.empty() && trouble != told) {
    Reason text{"the IMU reports: "};
    text += trouble;
    out.report(text.view());
  }
  told = trouble;
}

}  // namespace drydock::device
