#pragma once

#include <optional>
#include <string>

#include "hil/scorecard/fault_amounts.hpp"
#include "hil/scorecard/reference.hpp"

namespace drydock::scorecard {

/// The first sign of a fault, in words. The run without faults did not give it.
struct Sign {
  double at_s = 0;
  std::string what;
};

/// The sign comes from the device's driver, or from the estimators that use it, before the fault
/// ends. Changes of state and messages have their exact time; other signs have a resolution of
/// poll_s.
std::optional<Sign> first_sign(std::size_t device, const Window& window, const Reference& reference,
                               const RunRecord& run);

}  // namespace drydock::scorecard
