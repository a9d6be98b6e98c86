#pragma once

#include "drivers/wire/pgn_table/catalogue.hpp"
#include "drivers/wire/pgn_table/record.hpp"

namespace drydock::wire::pgn_table {

/// The values of a message, in the order of its definition. What the message marks as not
/// available, out of range or reserved has no content, and neither has what lies behind its end.
Message decode(const Catalogue& catalogue, const Definition& definition, Bytes message);

}  // namespace drydock::wire::pgn_table
