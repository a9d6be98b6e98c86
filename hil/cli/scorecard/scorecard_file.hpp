#pragma once

#include <string>
#include <vector>

#include "hil/cli/scorecard/scorecard.hpp"

/// The scorecard as a file: docs/use/scorecard.md names its keys.
namespace drydock::cli::scorecard {

/// A line for each pair, so that a change shows in review. Fractions have three digits.
std::string to_json_text(const Scorecard& card);

/// A line for each figure that the reference has otherwise, and for each pair that only one has;
/// pairs that this card did not try are left out. Throws std::runtime_error, one line, where the
/// reference is none, or one of another rig, seed or window.
std::vector<std::string> differences_from(const std::string& reference, const Scorecard& card);

}  // namespace drydock::cli::scorecard
