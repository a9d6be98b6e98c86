#pragma once

#include <string>

#include "hil/summary/summary.hpp"

namespace drydock::summary {

/// Error table and figures of one navigation estimator. Empty if the trace is empty.
std::string navigation_section(const std::optional<NavigationError>& error,
                               const NavigationTrace& trace);

}  // namespace drydock::summary
