#pragma once

#include <string>

namespace drydock::summary {

/// The result of one expectation of a run.
struct Verdict {
  std::string subject;   ///< name of the device or estimator
  std::string what;      ///< key of the summary: state, rate_hz, roll_rms_deg, ...
  std::string measured;  ///< "5.002", "stale at 12.3 s", or why there is no value
  std::string expected;  ///< "4.9 to 5.1", "at most 0", "streaming"
  bool passed = false;
  int line = 0;  ///< in the rig file; 0: requested on the command line
};

}  // namespace drydock::summary
