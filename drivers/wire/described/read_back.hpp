#pragma once

#include <string>

#include "drivers/wire/described/description.hpp"
#include "drivers/wire/described/plan.hpp"

namespace drydock::wire::described {

/// The line that an emulated device would write and the decoder would not take for this message;
/// empty: it takes it. Values may be out of what a pattern allows, so one of several is enough.
std::string line_not_read_back(const Plan& plan, const Message& message);

/// Bytes of the message as an emulated device would write it; 0: it cannot write it.
std::size_t bytes_written(const Plan& plan, const Message& message);

/// Why an emulated device of this description writes no message, in words; empty: it writes some.
std::string why_silent(const Description& description);

}  // namespace drydock::wire::described
