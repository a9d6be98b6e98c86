#pragma once

#include "drivers/link/opening.hpp"

namespace drydock::link {

/// The adapter refused the command (BEL), or gave no answer to it though it answered others. The
/// command is `S0` to `S8`, `O` or `L`. The message says what to do.
ErrorCode slcan_refused(std::string_view command);
ErrorCode slcan_unanswered(std::string_view command);

/// The rate is not one of the adapter's: another rate may be. False for all other errors.
bool is_refused_rate(const ErrorCode& error);

}  // namespace drydock::link
