#pragma once

#include <vector>

#include "hil/report/figure.hpp"
#include "hil/summary/summary.hpp"

namespace drydock::diff {

/// What both runs have, in one plot each: tracks, estimates, measurements. A label ends with "A" or
/// "B".
std::vector<report::Figure> figures_of(const summary::Summary& a, const summary::Summary& b);

}  // namespace drydock::diff
