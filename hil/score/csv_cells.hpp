#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace drydock::score {

/// Some programs of Windows begin a text with it.
inline std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  return text.substr(text.starts_with(mark) ? mark.size() : 0);
}

/// What stands between the cells of a file: of comma, semicolon and tab the one that is most often
/// in its first line.
char separator_of(std::string_view line);

/// The cells of a line, without the blanks around them and without quotation marks; a separator
/// between two of these belongs to the cell.
std::vector<std::string> csv_cells(std::string_view line, char separator);

}  // namespace drydock::score
