#include "hil/summary/truth_of_rig.hpp"

#include <algorithm>
#include <set>

#include "drivers/link/link.hpp"

namespace drydock::summary {
namespace {

bool emulated(const rig_config::DeviceConfig& device) {
  const auto uri = link::parse_uri(device.link);
  return uri && uri->emulated();
}

}  // namespace

std::vector<rig_config::DeviceConfig> emulated_devices(const rig_config::Rig& rig) {
  std::vector<rig_config::DeviceConfig> devices;
  std::copy_if(rig.devices.begin(), rig.devices.end(), std::back_inserter(devices), emulated);
  return devices;
}

bool no_real_device(const rig_config::Rig& rig) {
  return std::all_of(rig.devices.begin(), rig.devices.end(), emulated);
}

bool truth_for_estimators(const rig_config::Rig& rig) {
  return std::all_of(rig.estimators.begin(), rig.estimators.end(), [&](const auto& estimator) {
    return std::any_of(rig.devices.begin(), rig.devices.end(), [&](const auto& device) {
      const bool feeds = estimator.imu.empty() || device.name == estimator.imu;
      return feeds && emulated(device);
    });
  });
}

std::vector<std::string> can_notes(const rig_config::Rig& rig) {
  std::set<std::string> seen;
  std::vector<std::string> notes;
  for (const auto& device : rig.devices) {
    const auto uri = link::parse_uri(device.link);
    if (!uri || uri->scheme != link::Scheme::can_auto || !seen.insert(device.link).second) continue;
    notes.push_back("CAN bus " + device.link + ": " + link::can_auto_level(*uri));
  }
  return notes;
}

}  // namespace drydock::summary
