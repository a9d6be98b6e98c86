#pragma once

#include <string>

#include "hil/report/figure.hpp"

namespace drydock::report {

/// The plot as an SVG element, drawn by gnuplot. Empty if gnuplot is missing or fails.
std::string render_svg(const Figure& plot);

}  // namespace drydock::report
