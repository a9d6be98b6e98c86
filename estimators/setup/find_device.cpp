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

}  // namespace drydock::setup
