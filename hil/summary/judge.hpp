#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hil/summary/summary.hpp"
#include "hil/summary/verdict.hpp"
#include "rig_config/expect.hpp"

namespace drydock::summary {

/// What a run came to on one expectation, from its after_s on.
struct Findings {
  std::optional<DeviceSummary> device;        ///< or
  std::optional<EstimatorSummary> estimator;  ///< neither: the run ended before after_s
  double duration_s = 0;                      ///< of the run
  std::string other_state;  ///< "stale at 12.3 s": the first that was not expected; empty: none
};

/// A verdict for each figure of the block, in its order. Throws std::logic_error for a figure that
/// the summary does not have: the schema allows none.
std::vector<Verdict> judge(const rig_config::ExpectConfig& expect, const Findings& found);

/// "5 of 6 expectations met", with a line for each before it; empty without verdicts.
std::string to_text(const std::vector<Verdict>& verdicts);

}  // namespace drydock::summary
