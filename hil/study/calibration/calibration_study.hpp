#pragma once

#include "hil/study/study.hpp"

namespace drydock::study {

/// Emulated dives with random errors of DVL and compass: how often do the 95 % bounds of the
/// calibration hold the true value? On the same dives without these errors: is the covariance of
/// the smoother right, and by how much is it better than the filter between the fixes?
Result calibration_study(const Options& options, Progress& progress);

}  // namespace drydock::study
