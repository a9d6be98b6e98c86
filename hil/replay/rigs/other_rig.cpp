#include "hil/replay/rigs/other_rig.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

namespace drydock::replay {
namespace {

const record::RecordedLink* link_of(const record::Recording& recording, const std::string& device) {
  for (const auto& link : recording.links())
    if (std::ranges::find(link.devices, device) != link.devices.end()) return &link;
  return nullptr;
}

std::vector<std::string> devices_of(const record::Recording& recording) {
  std::vector<std::string> all;
  for (const auto& link : recording.links())
    all.insert(all.end(), link.devices.begin(), link.devices.end());
  return all;
}

const rig_config::DeviceConfig* device_named(const rig_config::Rig& rig, const std::string& name) {
  const auto found = std::ranges::find(rig.devices, name, &rig_config::DeviceConfig::name);
  return found == rig.devices.end() ? nullptr : &*found;
}

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

bool needs_any(const rig_config::EstimatorConfig& estimator,
               const std::vector<std::string>& names) {
  const auto compared = rig_config::devices_compared_by(estimator.kind);
  return has(names, estimator.imu) ||
         std::ranges::any_of(compared, [&](const auto& name) { return has(names, name); });
}

}  // namespace

void leave_out(const std::vector<std::string>& silent, OtherRig& other) {
  std::vector<std::string> gone = silent;
  std::erase_if(other.rig.devices, [&](const auto& device) { return has(silent, device.name); });
  std::erase_if(other.rig.estimators, [&](const auto& estimator) {
    if (!needs_any(estimator, silent)) return false;
    other.notes.push_back(estimator.name + ": left out, it needs a device that is left out");
    gone.push_back(estimator.name);
    return true;
  });
  std::erase_if(other.rig.expects, [&](const auto& expect) {
    return has(gone, expect.device) || has(gone, expect.estimator);
  });
}

OtherRig fit(rig_config::Rig rig, const record::Recording& recording,
             const rig_config::Rig& recorded) {
  OtherRig other{std::move(rig), {}};
  const auto note = [&](std::string line) { other.notes.push_back(std::move(line)); };
  const auto known = devices_of(recording);
  std::vector<std::string> silent;
  for (auto& device : other.rig.devices) {
    const auto* link = link_of(recording, device.name);
    if (link == nullptr) {
      silent.push_back(device.name);
      note(device.name + ": left out, the recording has no device of that name");
      continue;
    }
    device.link = link->uri;
    const auto* before = device_named(recorded, device.name);
    if (before != nullptr && before->protocol != device.protocol)
      note(fmt::format("{}: read as {}, recorded as {}", device.name, device.protocol,
                       before->protocol));
  }
  for (const auto& name : known)
    if (device_named(other.rig, name) == nullptr)
      note(name + ": only in the recording, this rig has no such device");
  leave_out(silent, other);
  if (other.rig.devices.empty())
    throw std::runtime_error(fmt::format("no device of {} is in the recording, which has {}",
                                         other.rig.file, fmt::join(known, ", ")));
  return other;
}

}  // namespace drydock::replay
