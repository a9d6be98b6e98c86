#pragma once

#include <memory>

#include "hil/motion/truth.hpp"
#include "rig_config/rig.hpp"

namespace drydock::motion {

/// The motion that a mission describes: its legs, kept to exactly or sailed by a
/// vehicle, or a ballistic flight. Throws
/// std::invalid_argument (one line) for a mission that cannot be flown.
std::unique_ptr<Trajectory> make_trajectory(const rig_config::MissionConfig& mission, Stamp start);

}  // namespace drydock::motion
