#pragma once

#include <CLI/CLI.hpp>
#include <cmath>
#include <optional>
#include <vector>

#include "drivers/measurement/units.hpp"
#include "estimators/frame/geodetic.hpp"

namespace drydock::program {

/// --start of a dive without a fix, for commands that make a track.
inline void add_start(CLI::App& sub, std::optional<frame::Position>& start) {
  sub.add_option_function<std::vector<double>>(
         "--start",
         [&start](const std::vector<double>& degrees) {
           if (!(std::abs(degrees.at(0)) <= 90) || !(std::abs(degrees.at(1)) <= 360))
             throw CLI::ValidationError(
                 "--start", "allowed: latitude,longitude in degrees, such as 41.5,-70.7");
           start = frame::Position{degrees[0] * units::degree, degrees[1] * units::degree, 0};
         },
         "latitude,longitude of a dive without a fix, degrees")
      ->delimiter(',')
      ->expected(2);
}

}  // namespace drydock::program
