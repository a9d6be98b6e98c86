#include <algorithm>

#include "estimators/setup/options_of.hpp"

namespace drydock::setup {

const rig_config::DeviceConfig* find_device(const rig_config::Rig& rig, const std::string& name) {
  const auto found = std::ranges::find(rig.devices, name, &rig_config::DeviceConfig::name);
  return found == rig.devices.end() ? nullptr : &*found;
}

std::optional<std::uint16_t> index_of(const rig_config::Rig& rig, const std::string& name) {
  if (name.empty()) return {};
  const auto found = std::ranges::find(rig.devices, name, &rig_config::DeviceConfig::name);
  return static_cast<std::uint16_t>(found - rig.devices.begin());
}

std::optional<pipeline::AidingSensor> witness_of(const EstimatorInRig& place) {
  const auto& devices = place.rig.devices;
  const auto dvl =
      std::ranges::find(devices, measurement::Kind::dvl, &rig_config::DeviceConfig::kind);
  const auto* imu = find_device(place.rig, place.estimator.imu);
  if (dvl == devices.end() || !imu) return {};
  return pipeline::AidingSensor{
      static_cast<std::uint16_t>(dvl - devices.begin()),
      Eigen::Vector3d{dvl->lever_arm_m.data()} - Eigen::Vector3d{imu->lever_arm_m.data()}};
}

}  // namespace drydock::setup
