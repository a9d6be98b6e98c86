#pragma once

#include "estimators/calibration/calibrate.hpp"
#include "hil/track/gathered.hpp"

namespace drydock::calibrate {

struct Outcome {
  track::Gathered gathered;  ///< its unstated noise is scaled to what was fitted
  calibration::Calibration calibration;
  /// Innovations with the sensors as the rig has them, and as they were found; noise and motion are
  /// those that were fitted.
  smoothing::Residuals before, after;
};

/// Calibrates the sensors of what was gathered. Throws std::runtime_error with one line if nothing
/// can be calibrated.
Outcome calibrated(track::Gathered gathered);

std::string to_text(const Outcome& outcome);
std::string to_json(const Outcome& outcome);
/// One self-contained HTML page: values with bounds, correlations, residuals before and after.
std::string to_html(const Outcome& outcome);

/// The rig file with what the dive told: mounting, lever arm, latency, the scale of a DVL as its
/// speed of sound, the scale of a log, the error of a compass. `notes` gets a line for each value
/// that no key of a rig file holds.
std::string calibrated_rig(const Outcome& outcome, std::vector<std::string>& notes);

}  // namespace drydock::calibrate
