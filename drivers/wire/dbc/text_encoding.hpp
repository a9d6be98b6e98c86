#pragma once

#include <string>
#include <string_view>

namespace drydock::wire::dbc {

/// The text in UTF-8. Tools write DBC files in Windows-1252 or, from scripts, in UTF-8: what is
/// not valid UTF-8 is read as Windows-1252. A byte-order mark is left out.
std::string to_utf8(std::string_view bytes);

}  // namespace drydock::wire::dbc
