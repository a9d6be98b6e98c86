#pragma once

#include <limits>
#include <string>
#include <vector>

namespace drydock::rig_config {

/// Values that are allowed, both ends with them. NaN is not.
struct Bounds {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();

  bool hold(double value) const { return value >= low && value <= high; }
};

/// A figure of a run's summary, as its key in the rig file without `_min` and `_max`: rate_hz,
/// reopens, roll_rms_deg, ...
struct ExpectedFigure {
  std::string name;
  Bounds allowed;
  int line = 0;  ///< in the rig file; 0: asked for on the command line
};

/// A block [[expect]]: what a run must come to, of one device or one estimator. docs/use/ci.md
struct ExpectConfig {
  std::string device, estimator;  ///< name; the other one is empty
  double after_s = 0;             ///< only what comes so long after the start counts
  std::string state;              ///< of the device; empty: any
  int state_line = 0;
  std::vector<ExpectedFigure> figures;
};

}  // namespace drydock::rig_config
