#pragma once

#include <optional>
#include <string>

#include "hil/motion/maneuver/maneuver.hpp"

namespace drydock::world {

/// The usual picture of a manoeuvre as SVG: the path of a turning circle or schedule,
/// heading and rudder of a zigzag, rate of turn over rudder of a spiral, pitch and depth of a dive.
/// Empty if gnuplot is missing.
std::string plot_svg(std::optional<motion::ManeuverKind> kind, const motion::Track& track);

}  // namespace drydock::world
