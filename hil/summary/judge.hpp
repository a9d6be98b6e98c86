#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hil/summary/summary.hpp"
#include "hil/summary/verdict.hpp"
#include "rig_config/expect.hpp"

namespace drydock::summary {

/// The results of a run for one expectation, from its after_s on. All are empty if the run ended
/// before that.
struct Outcome {
  std::optional<DeviceSummary> device;        ///< set for a block with a device
  std::optional<EstimatorSummary> estimator;  ///< set for a block with an estimator
  std::optional<std::vector<diagnosis::FindingAccount>>
      findings;             ///< of the block's device, or of all
  double duration_s = 0;    ///< the whole run
  std::string absent;       ///< why there is nothing to judge, if not that the run was short
  std::string other_state;  ///< "stale at 12.3 s": the first unexpected state; empty: none
};

/// One verdict per figure of the block, in its order. Throws std::logic_error for a figure that the
/// summary does not have; the schema allows no such figure.
std::vector<Verdict> judge(const rig_config::ExpectConfig& expect, const Outcome& found);

/// One line per verdict, then "5 of 6 expectations met". Empty if there are no verdicts.
std::string to_text(const std::vector<Verdict>& verdicts);

}  // namespace drydock::summary
