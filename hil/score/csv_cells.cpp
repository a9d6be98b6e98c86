#include "hil/score/csv_cells.hpp"

#include <algorithm>

namespace drydock::score {
namespace {

std::string trimmed(const std::string& cell) {
  constexpr const char* blanks = " \t\r";
  const auto first = cell.find_first_not_of(blanks);
  if (first == std::string::npos) return {};
  return cell.substr(first, cell.find_last_not_of(blanks) + 1 - first);
}

}  // namespace

char separator_of(std::string_view line) {
  char best = ',';
  for (const char other : {';', '\t'})
    if (std::ranges::count(line, other) > std::ranges::count(line, best)) best = other;
  return best;
}

std::vector<std::string> csv_cells(std::string_view line, char separator) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"')
      quoted = !quoted;
    else if (c == separator && !quoted)
      cells.emplace_back();
    else
      cells.back().push_back(c);
  }
  std::ranges::transform(cells, cells.begin(), trimmed);
  return cells;
}

}  // namespace drydock::score
