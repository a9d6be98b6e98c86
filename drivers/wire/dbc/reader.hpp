#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "drivers/wire/dbc/database.hpp"

namespace drydock::wire::dbc {

constexpr std::size_t longest_text = 16 * 1024 * 1024;  ///< bytes of a file
constexpr std::size_t most_remarks = 100;               ///< of each sort

/// A DBC text as it was read. A statement with an error is left out, and reading goes on at the
/// next; a database with errors is not complete.
struct Reading {
  Database database;
  std::vector<Remark> errors;    ///< what cannot be read
  std::vector<Remark> warnings;  ///< what can be read but is doubtful
  std::size_t remarks_left_out = 0;
};

/// Reads the bytes of a DBC file, UTF-8 or Windows-1252, LF or CRLF. Never throws but for memory.
Reading read(std::string_view bytes);

}  // namespace drydock::wire::dbc
