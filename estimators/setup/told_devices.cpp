#include "estimators/setup/told_devices.hpp"

namespace drydock::setup {

std::vector<external::Hello::Device> told_devices(const rig_config::Rig& rig) {
  std::vector<external::Hello::Device> devices;
  for (const auto& device : rig.devices)
    devices.push_back({.name = device.name,
                       .kind = std::string(measurement::to_string(device.kind)),
                       .rate_hz = device.rate_hz,
                       .lever_arm_m = device.lever_arm_m,
                       .mounting_rad = device.mounting_rad});
  return devices;
}

}  // namespace drydock::setup
