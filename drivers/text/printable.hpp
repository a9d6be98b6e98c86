#pragma once

#include <string>
#include <string_view>

namespace drydock::text {

/// Text from outside as a terminal, a log and a file may show it: whole characters of UTF-8 stay,
/// every control character and every byte that is none becomes '?'.
std::string printable(std::string_view bytes);

}  // namespace drydock::text
