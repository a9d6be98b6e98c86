#include "hil/report/table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "hil/report/html.hpp"

namespace drydock::report {
namespace {

using html::escaped;

/// The number of characters on a screen: UTF-8 bytes without continuation bytes.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (c & '\xC0') != '\x80'; }));
}

std::vector<std::size_t> widths_of(const Table& table) {
  std::vector<std::size_t> widths;
  for (const auto& name : table.columns) widths.push_back(width_of(name));
  for (const auto& row : table.rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
  return widths;
}

std::string line(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths) {
  std::string out;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::string gap(widths[i] - width_of(cells[i]), ' ');
    out += i == 0 ? cells[i] + gap : "  " + gap + cells[i];
  }
  out.erase(out.find_last_not_of(' ') + 1);
  return out + "\n";
}

}  // namespace

std::string to_html(const Table& table) {
  std::string out = "<h2>" + escaped(table.title) + "</h2>\n";
  if (!table.rows.empty()) {
    out += "<div class=scroll><table><tr>";
    for (const auto& name : table.columns) out += "<th>" + escaped(name);
    out += "</tr>\n";
    for (const auto& row : table.rows) {
      out += "<tr>";
      for (const auto& cell : row) out += "<td>" + escaped(cell);
      out += "</tr>\n";
    }
    out += "</table></div>\n";
  }
  return table.note.empty() ? out : out + "<p class=soft>" + escaped(table.note) + "</p>\n";
}

std::string to_text(const Table& table) {
  const auto widths = widths_of(table);
  std::string out = table.title + "\n" + line(table.columns, widths);
  for (const auto& row : table.rows) out += line(row, widths);
  return table.note.empty() ? out : out + table.note + "\n";
}

}  // namespace drydock::report
