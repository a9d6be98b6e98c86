#include "hil/report/labelled_tables.hpp"

#include <cstddef>
#include <string_view>
#include <vector>

namespace drydock::report {
namespace {

constexpr std::size_t most_columns = 3;  // side by side on a page of 390 px
constexpr std::string_view plain_table = "<table>";

/// The texts of the <th> of a table.
std::vector<std::string> columns_of(std::string_view table) {
  std::vector<std::string> names;
  for (auto at = table.find("<th"); at != table.npos; at = table.find("<th", at + 1)) {
    const auto begin = table.find('>', at) + 1;
    names.emplace_back(table.substr(begin, table.find('<', begin) - begin));
    while (!names.back().empty() && names.back().back() == '\n') names.back().pop_back();
  }
  return names;
}

std::string labelled(std::string_view table, const std::vector<std::string>& columns) {
  std::string out = "<table class=cards>";
  table.remove_prefix(plain_table.size());
  std::size_t column = 0;
  while (!table.empty()) {
    const auto at = table.find("<t", 1);
    if (table.starts_with("<tr")) column = 0;
    if (table.starts_with("<td") && column < columns.size()) {
      out += "<td data-label=\"" + columns[column++] + "\"";
      out += table.substr(3, at - 3);
    } else {
      out += table.substr(0, at);
    }
    table.remove_prefix(at == table.npos ? table.size() : at);
  }
  return out;
}

}  // namespace

std::string with_labels(const std::string& body) {
  std::string out;
  std::string_view rest = body;
  for (auto at = rest.find(plain_table); at != rest.npos; at = rest.find(plain_table)) {
    out += rest.substr(0, at);
    const auto table = rest.substr(at, rest.find("</table>", at) - at);
    const auto columns = columns_of(table);
    out += columns.size() > most_columns ? labelled(table, columns) : std::string(table);
    rest.remove_prefix(at + table.size());
  }
  return out.append(rest);
}

}  // namespace drydock::report
