#pragma once

#include <string>

#include "estimators/calibration/parameter.hpp"

namespace drydock::calibration {

/// Why no reading of this dive tells the parameter, whatever the likelihood says of it; empty: one
/// may. The model of the motion is a guess: where nothing is measured, it must not count.
std::string unobservable(const Parameter& parameter, const smoothing::Dive& dive);

}  // namespace drydock::calibration
