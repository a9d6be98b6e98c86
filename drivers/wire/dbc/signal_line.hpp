#pragma once

#include "drivers/wire/dbc/multiplexing.hpp"
#include "drivers/wire/dbc/scanner.hpp"

namespace drydock::wire::dbc {

/// Reads a signal behind the word SG_. Throws Unreadable.
Signal read_signal(Scanner& in, Choice& choice);

}  // namespace drydock::wire::dbc
