#pragma once

#include <optional>
#include <string>

#include "hil/scorecard/fault_amounts.hpp"
#include "hil/scorecard/reference.hpp"

namespace drydock::scorecard {

/// The first sign of a fault, in words, that the run without faults did not give.
struct Sign {
  double at_s = 0;
  std::string what;
};

/// Of the device's driver, or of the estimators that it feeds; until the end of the fault. Changes
/// of state and messages are known to the moment, all else to poll_s.
std::optional<Sign> first_sign(std::size_t device, const Window& window, const Reference& reference,
                               const RunRecord& run);

}  // namespace drydock::scorecard
