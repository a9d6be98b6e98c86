#pragma once

#include "drivers/wire/dbc/remarks.hpp"

namespace drydock::wire::dbc {

/// Warns of signals that end beyond their message or share bits with another that can be present at
/// the same time. Both occur in published files.
void check_layout(const Message& message, Remarks& remarks);

}  // namespace drydock::wire::dbc
