#pragma once

#include <string>

#include "hil/report/figure.hpp"

namespace drydock::report {

/// The figure as JSON for the page's script, to seven digits. NaN and infinity are null. The text
/// may stand inside a <script>: it has no '<'.
std::string to_json(const Figure& figure);

}  // namespace drydock::report
