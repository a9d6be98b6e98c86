#pragma once

#include <cstdio>
#include <string>

namespace drydock::check {

/// A file of messages of a CAN bus, by its name.
bool is_dbc(const std::string& file);

/// Prints each error and each doubtful place of a DBC file with line and column. True: it has no
/// error.
bool check_dbc(const std::string& file, std::FILE* out);

}  // namespace drydock::check
