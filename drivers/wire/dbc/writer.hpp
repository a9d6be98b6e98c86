#pragma once

#include <span>
#include <string>

#include "drivers/wire/dbc/database.hpp"

namespace drydock::wire::dbc {

/// The text of a DBC file in UTF-8 with these messages: all that read() knows of them. For people:
/// it allocates.
std::string write(std::span<const Message> messages);

}  // namespace drydock::wire::dbc
