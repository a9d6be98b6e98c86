#pragma once

#include <limits>
#include <string>
#include <vector>

namespace drydock::rig_config {

/// The range of allowed values, including both ends. NaN is not allowed.
struct Bounds {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();

  bool hold(double value) const { return value >= low && value <= high; }
};

/// A figure of the summary of a run. `name` is its key in the rig file without `_min` and `_max`:
/// rate_hz, reopens, roll_rms_deg, ...
struct ExpectedFigure {
  std::string name;
  Bounds allowed;
  int line = 0;  ///< in the rig file; 0: from the command line
};

/// A block [[expect]]: the required results of a run for one device, one estimator or the whole
/// rig. docs/use/ci.md
struct ExpectConfig {
  std::string device, estimator;  ///< name; the other one is empty, both for the whole rig
  double after_s = 0;             ///< data before this time from the start do not count
  std::string state;              ///< of the device; empty: any
  int state_line = 0;
  std::vector<ExpectedFigure> figures;
};

}  // namespace drydock::rig_config
