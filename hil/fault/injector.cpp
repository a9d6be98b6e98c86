#include "hil/fault/injector.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "drivers/link/uri.hpp"

namespace drydock::fault {

namespace {

/// Empty if this program emulates the device; else the reason of the refusal.
std::optional<std::string> not_played(const DeviceConfig& device) {
  const auto uri = link::parse_uri(device.link);
  if (!uri || uri->emulated()) return {};
  return fmt::format("device \"{}\" is not emulated, its link is {}; allowed: {}", device.name,
                     device.link, uri->recorded() ? "drydock replay" : "drydock proxy");
}

}  // namespace

rig_config::Problems check_faults(const rig_config::Rig& rig) {
  auto problems = rig_config::check_faults_of(rig);
  for (const FaultConfig& fault : rig.faults) {
    const auto device = std::ranges::find(rig.devices, fault.device, &DeviceConfig::name);
    if (device == rig.devices.end()) continue;
    if (const auto why = not_played(*device))
      problems.push_back({fault.file, fault.line, 1, "/fault", *why});
  }
  return problems;
}

Injector::Injector(const rig_config::Rig& rig, const motion::Trajectory& trajectory, Stamp start)
    : rig_(rig),
      trajectory_(trajectory),
      start_(start),
      schedules_(rig, start, rig_config::FaultTarget::emulated) {}

Injector::Made Injector::device(const DeviceConfig& config) {
  auto made = FaultyDevice::make(config, trajectory_, rig_.seed, schedules_.of(config.name));
  if (!made) return made.error();
  return std::unique_ptr<emulate::EmulatedDevice>(std::move(*made));
}

std::unique_ptr<emulate::EmulatedDevice> Injector::rogue(const DeviceConfig& config,
                                                         unsigned bit_rate) {
  return std::make_unique<RogueNode>(config, bit_rate, rig_.seed, start_,
                                     schedules_.of(config.name));
}

boost::system::result<void, rig_config::Problems> Injector::set(const FaultConfig& fault,
                                                                Stamp now) {
  rig_config::Rig asked;
  asked.devices = rig_.devices;
  asked.faults = {fault};
  if (auto problems = check_faults(asked); !problems.empty()) return problems;
  return schedules_.set(fault, now);
}

}  // namespace drydock::fault
