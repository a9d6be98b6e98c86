#include "hil/fault/schedule/schedules.hpp"

#include "drivers/measurement/earlier.hpp"
#include "rig_config/fault_vocabulary.hpp"

namespace drydock::fault {

Schedules::Schedules(const rig_config::Rig& rig, Stamp start, rig_config::FaultTarget target)
    : rig_(rig), target_(target) {
  for (const auto& device : rig.devices)
    by_device_.emplace(device.name, std::make_shared<Schedule>(start));
  for (const auto& fault : rig.faults) by_device_.at(fault.device)->add(fault);
}

boost::system::result<void, rig_config::Problems> Schedules::set(const FaultConfig& fault,
                                                                 Stamp now) {
  rig_config::Rig asked;
  asked.devices = rig_.devices;
  asked.faults = {fault};
  if (auto problems = check_faults_of(asked, target_); !problems.empty()) return problems;
  by_device_.at(fault.device)->set(fault, now);
  return {};
}

std::size_t Schedules::clear(const std::string& device, std::optional<FaultKind> kind) {
  std::size_t cleared = 0;
  for (auto& [name, schedule] : by_device_)
    if (device.empty() || device == name) cleared += schedule->clear(kind);
  return cleared;
}

std::vector<FaultNow> Schedules::in_force(Stamp at) const {
  std::vector<FaultNow> all;
  for (const auto& [name, schedule] : by_device_)
    for (const InForce& now : schedule->in_force(at))
      all.push_back({name, std::string(rig_config::word_of(now.fault->kind).name), now.fault->words,
                     now.since, now.until});
  return all;
}

std::optional<Stamp> Schedules::next_change(Stamp after) const {
  std::optional<Stamp> next;
  for (const auto& [name, schedule] : by_device_)
    next = measurement::earlier(next, schedule->next_change(after));
  return next;
}

}  // namespace drydock::fault
