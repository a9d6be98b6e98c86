#pragma once

#include <string>

#include "hil/world/sky.hpp"

namespace drydock::world {

/// The sky over the listing's place as a polar plot: north is up, east is right, the zenith is in
/// the middle, the horizon is outside. Each satellite has its track of the last hour. A
/// self-contained SVG document.
std::string sky_plot_svg(const SkyListing& listing);

}  // namespace drydock::world
