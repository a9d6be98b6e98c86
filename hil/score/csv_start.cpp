#include "hil/score/csv_start.hpp"

#include "hil/score/csv_cells.hpp"
#include "hil/score/numbers.hpp"
#include "hil/score/ros_lines.hpp"

namespace drydock::score {
namespace {

bool is_comment(std::string_view line) { return line.starts_with('#') || line.starts_with('%'); }

/// Names of columns are behind a `#` as often as a remark is; they have a separator, and a line of
/// numbers follows.
bool begins_with_number(std::string_view line) {
  const auto cells = csv_cells(line, separator_of(line));
  return stamp_of_any(cells[0]).has_value();
}

}  // namespace

CsvStart start_of_csv(std::istream& in) {
  CsvStart start;
  std::string line, comment;
  std::uint64_t number = 0, comment_at = 0;
  while (std::getline(in, line)) {
    ++number;
    if (number == 1) line = without_byte_order_mark(line);
    if (line.empty() || line == "\r") continue;
    if (!is_comment(line)) break;
    comment = line;
    comment_at = number;
    line.clear();
  }
  const bool names_in_comment = !comment.empty() && (line.empty() || begins_with_number(line));
  const std::string& names = names_in_comment ? comment : line;
  start.separator = separator_of(names);
  start.line = names_in_comment ? comment_at : number;
  start.at = number;
  start.names = csv_cells(names, start.separator);
  if (names_in_comment) {
    start.names[0].erase(0, start.names[0].find_first_not_of("#% "));
    start.first = line;
  } else if (auto ros = names_of_ros_line(start.names); !ros.empty()) {
    start.names = std::move(ros);
    start.first = line;
  }
  return start;
}

}  // namespace drydock::score
