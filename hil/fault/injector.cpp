#include "hil/fault/injector.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "drivers/link/uri.hpp"

namespace drydock::fault {

namespace {

/// Nothing where this program plays the device.
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
    : rig_(rig), trajectory_(trajectory), start_(start) {
  for (const auto& device : rig.devices)
    schedules_.emplace(device.name, std::make_shared<Schedule>(start));
  for (const auto& fault : rig.faults) schedules_.at(fault.device)->add(fault);
}

Injector::Made Injector::device(const DeviceConfig& config) {
  auto made = FaultyDevice::make(config, trajectory_, rig_.seed, schedules_.at(config.name));
  if (!made) return made.error();
  return std::unique_ptr<emulate::EmulatedDevice>(std::move(*made));
}

std::unique_ptr<emulate::EmulatedDevice> Injector::rogue(const DeviceConfig& config,
                                                         unsigned bit_rate) {
  return std::make_unique<RogueNode>(config, bit_rate, rig_.seed, start_,
                                     schedules_.at(config.name));
}

boost::system::result<void, rig_config::Problems> Injector::set(const FaultConfig& fault,
                                                                Stamp now) {
  rig_config::Rig asked;
  asked.devices = rig_.devices;
  asked.faults = {fault};
  if (auto problems = check_faults(asked); !problems.empty()) return problems;
  schedules_.at(fault.device)->set(fault, now);
  return {};
}

std::size_t Injector::clear(const std::string& device, std::optional<FaultKind> kind) {
  std::size_t cleared = 0;
  for (auto& [name, schedule] : schedules_)
    if (device.empty() || device == name) cleared += schedule->clear(kind);
  return cleared;
}

std::vector<FaultNow> Injector::in_force(Stamp at) const {
  std::vector<FaultNow> all;
  for (const auto& [name, schedule] : schedules_)
    for (const InForce& now : schedule->in_force(at))
      all.push_back({name, std::string(rig_config::word_of(now.fault->kind).name), now.fault->words,
                     now.since, now.until});
  return all;
}

std::optional<Stamp> Injector::next_change(Stamp after) const {
  std::optional<Stamp> next;
  for (const auto& [name, schedule] : schedules_) {
    const auto change = schedule->next_change(after);
    if (change && (!next || *change < *next)) next = change;
  }
  return next;
}

}  // namespace drydock::fault
