#include "estimators/host/diagnostician.hpp"

#include "estimators/frame/attitude.hpp"

namespace drydock::host {
namespace {

diagnosis::Expected expected_of(const rig_config::DeviceConfig& config, std::size_t device) {
  const wire::Protocol* const protocol = rig_config::protocol_of(config);
  return {.device = static_cast<std::uint16_t>(device),
          .kind = config.kind,
          .protocol = protocol != nullptr ? *protocol : wire::Protocol{},
          .nominal_rate_hz = config.rate_hz};
}

std::vector<consistency::Sensor> sensors_of(const rig_config::Rig& rig) {
  std::vector<consistency::Sensor> sensors;
  for (const auto& config : rig.devices) {
    const auto& [roll, pitch, yaw] = config.mounting_rad;
    sensors.push_back({.kind = config.kind,
                       .rate_hz = config.rate_hz,
                       .lever_arm_m = Eigen::Vector3d(config.lever_arm_m.data()),
                       .sensor_to_body = frame::ned_to_body({roll, pitch, yaw}).transpose()});
  }
  return sensors;
}

}  // namespace

Diagnostician::Diagnostician(const rig_config::Rig& rig, Follower& to)
    : teller_(to), judge_(rig.devices.size(), teller_), cross_checks_(sensors_of(rig), judge_) {
  monitors_.reserve(rig.devices.size());
  for (std::size_t i = 0; i < rig.devices.size(); ++i)
    monitors_.emplace_back(expected_of(rig.devices[i], i), judge_);
}

void Diagnostician::on_measurement(const measurement::Measurement& measurement) {
  const auto& origin = measurement::origin_of(measurement);
  monitors_.at(origin.device).take(measurement);
  cross_checks_.take(measurement);
  if (origin.received_at >= next_look_) look(origin.received_at);
}

void Diagnostician::look(Stamp now) {
  for (std::size_t i = 0; i < devices_.size(); ++i)
    monitors_.at(i).look(devices_[i]->health(now), now);
  cross_checks_.tell(now);
  judge_.settle(now);
  next_look_ = now + diagnosis::look_period;
}

}  // namespace drydock::host
