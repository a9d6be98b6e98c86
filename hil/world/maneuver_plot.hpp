#pragma once

#include <optional>
#include <string>

#include "hil/motion/maneuver/maneuver.hpp"

namespace drydock::world {

/// Draws the usual picture of a manoeuvre as an SVG file: the path of a turning circle or schedule,
/// heading and rudder of a zigzag, rate of turn over rudder of a spiral, pitch and depth of a dive.
/// False if gnuplot is missing or the file cannot be written.
bool write_plot(const std::string& path, std::optional<motion::ManeuverKind> kind,
                const motion::Track& track);

}  // namespace drydock::world
