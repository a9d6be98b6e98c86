#include "estimators/host/diagnostician.hpp"

namespace drydock::host {
namespace {

diagnosis::Expected expected_of(const rig_config::DeviceConfig& config, std::size_t device) {
  const wire::Protocol* const protocol = rig_config::protocol_of(config);
  return {.device = static_cast<std::uint16_t>(device),
          .kind = config.kind,
          .protocol = protocol != nullptr ? *protocol : wire::Protocol{},
          .nominal_rate_hz = config.rate_hz};
}

}  // namespace

Diagnostician::Diagnostician(const rig_config::Rig& rig, Follower& to)
    : teller_(to), judge_(rig.devices.size(), teller_) {
  monitors_.reserve(rig.devices.size());
  for (std::size_t i = 0; i < rig.devices.size(); ++i)
    monitors_.emplace_back(expected_of(rig.devices[i], i), judge_);
}

void Diagnostician::on_measurement(const measurement::Measurement& measurement) {
  const auto& origin = measurement::origin_of(measurement);
  monitors_.at(origin.device).take(measurement);
  if (origin.received_at >= next_look_) look(origin.received_at);
}

void Diagnostician::look(Stamp now) {
  for (const auto* device : devices_) monitors_.at(device->index()).look(device->health(now), now);
  judge_.settle(now);
  next_look_ = now + diagnosis::look_period;
}

}  // namespace drydock::host
