#include "hil/bench/joint_troubles.hpp"

#include "rig_config/fault_vocabulary.hpp"

namespace drydock::bench {
namespace {

void add(const rig_config::FaultConfig& fault, steer::JointTrouble& to) {
  using rig_config::FaultKind;
  switch (fault.kind) {
    case FaultKind::stuck: to.stuck = true; break;
    case FaultKind::off: to.powerless = true; break;
    case FaultKind::hang:
    case FaultKind::unplug: to.deaf = true; break;
    case FaultKind::delay: to.late = measurement::from_seconds(fault.amount[0]); break;
    default: break;
  }
}

}  // namespace

steer::JointTroubles joint_troubles(const rig_config::Rig& rig, const fault::Injector& injector,
                                    measurement::Stamp now) {
  steer::JointTroubles troubles;
  for (const auto& device : rig.devices) {
    if (device.kind != rig_config::DeviceKind::actuator) continue;
    for (const auto& [fault, since, until] : injector.faults_of(device.name, now))
      add(*fault, troubles[device.name]);
  }
  return troubles;
}

}  // namespace drydock::bench
