#pragma once

#include <string>

#include "hil/world/sky.hpp"

namespace drydock::world {

/// The sky over the listing's place as a polar plot: north up, east right, the zenith in the
/// middle, the horizon outside; each satellite with its way over the last hour. An SVG document
/// that needs nothing else.
std::string sky_plot_svg(const SkyListing& listing);

}  // namespace drydock::world
