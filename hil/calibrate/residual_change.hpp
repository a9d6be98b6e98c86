#pragma once

#include <string>
#include <vector>

#include "hil/calibrate/outcome.hpp"

namespace drydock::calibrate {

/// The innovations of one quantity of one device, with the sensors as the rig has them and as they
/// were found: RMS over all axes (m/s, m, rad) and mean normalised square.
struct ResidualChange {
  std::uint16_t device = 0;
  smoothing::Quantity quantity = smoothing::Quantity::bottom;
  double rms_before = 0, rms_after = 0;
  double nis_before = 0, nis_after = 0;
};

std::vector<ResidualChange> residual_changes(const Outcome& outcome);

}  // namespace drydock::calibrate
