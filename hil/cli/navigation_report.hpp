#pragma once

#include <string>

#include "hil/cli/summary.hpp"

namespace drydock::cli {

/// Error table and figures of one navigation estimator. Empty if the trace is empty.
std::string navigation_section(const std::optional<NavigationError>& error,
                               const NavigationTrace& trace);

}  // namespace drydock::cli
