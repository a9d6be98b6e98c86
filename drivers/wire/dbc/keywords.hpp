#pragma once

#include <string_view>

#include "drivers/wire/dbc/scanner.hpp"

namespace drydock::wire::dbc {

/// True for a word that begins a statement or a signal.
bool is_keyword(std::string_view word);

/// True for statements that say nothing about the content of frames.
bool is_skipped(std::string_view word);

/// True if a name comes, not the next statement.
inline bool next_is_name(const Scanner& in) {
  return !in.next_word().empty() && !is_keyword(in.next_word());
}

}  // namespace drydock::wire::dbc
