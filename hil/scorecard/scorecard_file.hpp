#pragma once

#include <string>
#include <vector>

#include "hil/scorecard/scorecard.hpp"

/// The scorecard as a file; docs/use/scorecard.md describes its keys.
namespace drydock::scorecard {

/// Each pair is one line, so that a review shows changes. Fractions have three digits.
std::string to_json_text(const Scorecard& card);

/// One line for each figure that differs from the reference, and for each pair that only one of
/// them has; pairs that this card did not try are left out. Throws std::runtime_error with one line
/// if the reference is not a scorecard, or has another rig, seed or window.
std::vector<std::string> differences_from(const std::string& reference, const Scorecard& card);

}  // namespace drydock::scorecard
