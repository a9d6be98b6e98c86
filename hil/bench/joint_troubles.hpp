#pragma once

#include "hil/fault/injector.hpp"
#include "hil/steer/joint_helm.hpp"

namespace drydock::bench {

/// What the faults of the rig's actuators do to the joints of the same names, for a vehicle that
/// another program steers: docs/world/steering.md
steer::JointTroubles joint_troubles(const rig_config::Rig& rig, const fault::Injector& injector,
                                    measurement::Stamp now);

}  // namespace drydock::bench
