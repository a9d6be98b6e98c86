#include "drivers/capture/table_row.hpp"

#include <algorithm>

namespace drydock::capture {
namespace {

std::string_view without_blanks(std::string_view field) {
  constexpr std::string_view around = " \t";
  field.remove_prefix(std::min(field.find_first_not_of(around), field.size()));
  return field.substr(0, field.find_last_not_of(around) + 1);
}

}  // namespace

TableRow row_of(std::string_view line, char separator) {
  TableRow row;
  while (row.size() < row.capacity()) {
    const bool quoted = line.starts_with('"');
    const std::size_t quote = quoted ? line.find('"', 1) : 0;
    if (quote == line.npos) break;  // the line was cut
    const std::size_t end = std::min(line.find(separator, quote), line.size());
    row.push_back(quoted ? line.substr(1, quote - 1) : without_blanks(line.substr(0, end)));
    if (end == line.size()) break;
    line.remove_prefix(end + 1);
  }
  return row;
}

char separator_of(std::string_view head) {
  const std::size_t quote = head.starts_with('"') ? std::min(head.find('"', 1), head.size()) : 0;
  const std::size_t at = head.find_first_of(",;\t", quote);
  return at == head.npos ? '\0' : head[at];
}

}  // namespace drydock::capture
