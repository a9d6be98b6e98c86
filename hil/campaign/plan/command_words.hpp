#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace drydock::campaign {

/// The words of a command, between blanks. A word that begins with a quote (' or ") goes to the
/// next one, blanks and all, and both are taken off. Inside a word a quote is a character as any
/// other: JSON has them. Empty: a quote is not closed.
std::optional<std::vector<std::string>> command_words(std::string_view command);

}  // namespace drydock::campaign
