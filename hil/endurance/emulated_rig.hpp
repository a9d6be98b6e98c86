#pragma once

#include "rig_config/rig.hpp"

namespace drydock::endurance {

/// The rig with an emulated line or bus in the place of each real link, at the same rate. Devices
/// that shared a link still do. So a bench of real sensors has a healthy twin in virtual time.
rig_config::Rig all_emulated(rig_config::Rig rig);

}  // namespace drydock::endurance
