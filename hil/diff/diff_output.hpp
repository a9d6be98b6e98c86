#pragma once

#include <string>

#include "hil/diff/differences.hpp"
#include "hil/diff/side.hpp"

namespace drydock::diff {

/// A table of what differs.
std::string to_text(const Side& a, const Side& b, const Comparison& comparison);

/// One object: "a", "b", "compared", "differences" with "what", "a", "b", "change".
std::string to_json(const Side& a, const Side& b, const Comparison& comparison);

/// A page with the table, and of two recordings with the curves of both in one plot.
std::string to_html(const Side& a, const Side& b, const Comparison& comparison);

}  // namespace drydock::diff
