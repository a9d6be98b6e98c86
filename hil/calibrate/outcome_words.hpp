#pragma once

#include <string>
#include <string_view>

#include "hil/calibrate/outcome.hpp"

/// A calibration in words, as the text and the page have them. Angles are shown in degrees.
namespace drydock::calibrate {

double shown(const calibration::Finding& finding, double value);
std::string shown_unit(const calibration::Finding& finding);  ///< empty: a pure number
std::string full_name(const Outcome& outcome, const calibration::Finding& finding);
std::string_view verdict_text(calibration::Verdict verdict);
std::string why_of(const Outcome& outcome, const calibration::Finding& finding);
/// "settled after 5 iterations"
std::string settled_text(const calibration::Calibration& calibration);

}  // namespace drydock::calibrate
