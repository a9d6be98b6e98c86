#pragma once

#include <string>

#include "drivers/wire/described/plan.hpp"

namespace drydock::wire::described {

/// The line that an emulated device would write and the decoder would not take for this message;
/// empty: it takes it. Values may be out of what a pattern allows, so one of several is enough.
std::string line_not_read_back(const Plan& plan, const Message& message);

}  // namespace drydock::wire::described
