#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace drydock::campaign {

/// The words of a command, between blanks. Quotes ('...' and "...") hold blanks together and are
/// taken off, as in a shell; nothing else has a meaning. Empty: a quote is not closed.
std::optional<std::vector<std::string>> command_words(std::string_view command);

}  // namespace drydock::campaign
