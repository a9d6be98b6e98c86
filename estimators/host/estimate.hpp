#pragma once

#include "rig_config/rig.hpp"

namespace drydock::host {

struct EstimateOptions {
  double duration_s = 0;    ///< 0: until Ctrl-C
  bool json_lines = false;  ///< every estimate as a JSON line instead of one line a second
};

/// Runs the estimators of a rig on the measurements of the bus and publishes their estimates. Says
/// on standard error what is wrong with the measurements. Returns 0, or 1 if there was no estimate.
int estimate(const rig_config::Rig& rig, const EstimateOptions& options);

}  // namespace drydock::host
