#pragma once

#include <string>
#include <vector>

namespace drydock::report {

/// A printable table: the paper's figures beside ours. Every row has as many cells as there are
/// columns.
struct Table {
  std::string title;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
  std::string note;  ///< below the table; may be empty
};

/// Columns side by side. The first is aligned left, the others right. The text ends with a newline.
std::string to_text(const Table& table);

/// A heading, the table and its note. Without rows there is no table.
std::string to_html(const Table& table);

}  // namespace drydock::report
