#pragma once

#include <memory>
#include <optional>

#include "hil/motion/truth.hpp"
#include "rig_config/rig.hpp"

namespace drydock::motion {

/// The motion of a mission: its legs, followed exactly or sailed by a simulated vehicle, a track
/// from a file, or a ballistic flight. Throws BadMission for a mission that is not possible,
/// ocean::BadRaster for a bed that is not, std::invalid_argument for a vehicle that is not.
std::unique_ptr<Trajectory> make_trajectory(const rig_config::MissionConfig& mission, Stamp start);

/// Seconds from the start of a ballistic flight to its impact: what its sensors say behind it, no
/// sensor could. Empty: the mission is no flight.
std::optional<double> flight_s(const rig_config::Rig& rig);

}  // namespace drydock::motion
