#include "hil/fault/injector.hpp"

namespace drydock::fault {

Injector::Injector(const rig_config::Rig& rig, const motion::Trajectory& trajectory, Stamp start)
    : rig_(rig),
      trajectory_(trajectory),
      start_(start),
      schedules_(rig, start, rig_config::FaultTarget::emulated) {}

boost::system::result<std::unique_ptr<emulate::EmulatedDevice>, emulate::EmulateError>
Injector::device(const DeviceConfig& config) {
  auto made = FaultyDevice::make(config, trajectory_, rig_.seed, schedules_.of(config.name));
  if (!made) return made.error();
  return std::unique_ptr<emulate::EmulatedDevice>(std::move(*made));
}

std::unique_ptr<emulate::EmulatedDevice> Injector::rogue(const DeviceConfig& config,
                                                         unsigned bit_rate) {
  return std::make_unique<RogueNode>(config, bit_rate, rig_.seed, start_,
                                     schedules_.of(config.name));
}

}  // namespace drydock::fault
