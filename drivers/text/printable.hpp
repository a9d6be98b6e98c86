#pragma once

#include <string>
#include <string_view>

namespace drydock::text {

/// Text from outside as a terminal, a log and a file may show it: whole characters of UTF-8 stay,
/// every control character and every byte that is none becomes '?'.
std::string printable(std::string_view bytes);
/// The same of a text of lines: their ends and tabs stay.
std::string printable_lines(std::string_view text);

}  // namespace drydock::text
