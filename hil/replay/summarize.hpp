#pragma once

#include <string>

#include "hil/summary/summary.hpp"

namespace drydock::replay {

/// Plays a recording through its rig's drivers and estimators, in virtual time, and says what came
/// out. Throws std::runtime_error with one line.
summary::Summary summarize(const std::string& recording);

}  // namespace drydock::replay
