#pragma once

#include <string>

#include "hil/study/figure.hpp"

namespace drydock::report {

using Series = study::Curve;
using Plot = study::Figure;

/// The plot as an SVG element, drawn by gnuplot. Empty if gnuplot is missing or fails.
std::string render_svg(const Plot& plot);

}  // namespace drydock::report
