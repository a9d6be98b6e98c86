#include "drivers/survey/driver_trial.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "drivers/measurement/units.hpp"

namespace drydock::survey {
namespace {

constexpr double least_plausible_share = 0.9;

bool plausible(const measurement::ImuSample& m) {
  constexpr double fastest_radps = 35;  // 2000 deg/s, the widest range of such units
  const double g = m.specific_force.norm() / units::standard_gravity;
  return g > 0.3 && g < 3 && m.angular_rate.norm() < fastest_radps;
}

/// Empty: without a pressure there is nothing to judge.
std::optional<bool> plausible(const measurement::DepthSample& m) {
  if (!m.pressure_pa) return {};
  return *m.pressure_pa > 0.2e5 && measurement::is_sea_pressure(*m.pressure_pa);
}

device::DeviceOptions options_for(Kind kind, std::string_view protocol, std::uint8_t address) {
  device::DeviceOptions options;
  options.name = to_string(kind);
  options.driver.kind = kind;
  options.driver.protocol = protocol;
  options.driver.address = address;
  return options;
}

device::DeviceOptions options_for(const wire::described::DescriptionPtr& description) {
  auto options = options_for(description->kind.value(), description->name, 0);
  options.driver.description = description;
  return options;
}

}  // namespace

DriverTrial::DriverTrial(Kind kind, std::string_view protocol, std::uint8_t address)
    : DriverTrial(options_for(kind, protocol, address)) {}

DriverTrial::DriverTrial(const wire::described::DescriptionPtr& description)
    : DriverTrial(options_for(description)) {}

DriverTrial::DriverTrial(device::DeviceOptions options) {
  options.life_cycle.reopen_when_quiet = false;
  auto made = device::Device::make(std::move(options));
  if (!made) throw std::invalid_argument(made.error().message);
  device_ = std::move(*made);
  device_->connect(*this, *this);
}

void DriverTrial::begin(Stamp at) {
  now_ = at;
  if (std::exchange(begun_, true)) return;
  device_->start(at);
  device_->opened(at, measurement::Provenance::real);
}

void DriverTrial::receive(wire::Bytes bytes, Stamp at) {
  begin(at);
  device_->receive(bytes, at);
}

void DriverTrial::receive(const wire::CanFrame& frame, Stamp at) {
  begin(at);
  device_->receive(frame, at);
}

/// The last line of a recording may have no end.
void DriverTrial::finish(Stamp at) {
  constexpr std::uint8_t line_end[] = {'\n'};
  if (!begun_) return;
  if (device_->vitals().held_bytes > 0) device_->receive(wire::Bytes(line_end), at);
}

void DriverTrial::on_measurement(const measurement::Measurement& measurement) {
  ++measurements_;
  if (const auto* imu = std::get_if<measurement::ImuSample>(&measurement)) {
    ++judged_;
    plausible_ += plausible(*imu);
    force_sum_mps2_ += imu->specific_force.norm();
    ++forces_;
  }
  if (const auto* depth = std::get_if<measurement::DepthSample>(&measurement)) {
    const auto verdict = plausible(*depth);
    judged_ += verdict.has_value();
    plausible_ += verdict.value_or(false);
  }
}

SensorHeard DriverTrial::heard() const {
  const auto& description = device_->options().driver.description;
  if (description)
    return {kind(), description->name, measurements_, device_->health(now_).rate_hz, description};
  // Names in the registry have static storage; the device's own copy ends with the trial.
  const auto known = device::protocols_of(kind());
  const auto name = std::ranges::find(known, protocol(), &device::ProtocolEntry::name)->name;
  return {kind(), name, measurements_, device_->health(now_).rate_hz, {}};
}

double DriverTrial::plausible_share() const {
  const std::uint64_t judged = judged_ + device_->health(now_).impossible;
  return judged == 0 ? 1 : static_cast<double>(plausible_) / static_cast<double>(judged);
}

std::optional<double> DriverTrial::gravity_error() const {
  if (forces_ == 0) return {};
  return std::abs(force_sum_mps2_ / static_cast<double>(forces_) / units::standard_gravity - 1);
}

std::vector<std::unique_ptr<DriverTrial>> trials_of(std::string_view protocol,
                                                    std::uint8_t address) {
  std::vector<std::unique_ptr<DriverTrial>> trials;
  const wire::Protocol* known = wire::find_protocol(protocol);
  for (const Kind kind : measurement::kinds) {
    if (known && known->kinds.has(kind))
      trials.push_back(std::make_unique<DriverTrial>(kind, protocol, address));
  }
  return trials;
}

std::vector<std::unique_ptr<DriverTrial>> trials_of(
    const wire::described::DescriptionPtr& description) {
  std::vector<std::unique_ptr<DriverTrial>> trials;
  trials.push_back(std::make_unique<DriverTrial>(description));
  return trials;
}

const DriverTrial* better_of(const DriverTrial* a, const DriverTrial* b) {
  if (b->measurements() == 0 || b->plausible_share() < least_plausible_share) return a;
  if (a == nullptr || b->measurements() > a->measurements()) return b;
  // Two scales of one layout: the right sensor measures its own gravity better.
  const bool same = b->measurements() == a->measurements();
  const bool weighs_better =
      a->gravity_error() && b->gravity_error() && *b->gravity_error() < *a->gravity_error();
  return same && weighs_better ? b : a;
}

}  // namespace drydock::survey
