#include "tests/estimators/navigation/recordings/table.hpp"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>

namespace drydock::navigation::test {

Read<std::string> read_text(const std::filesystem::path& file) {
  std::ifstream in{file, std::ios::binary};
  if (!in) return Refusal{file, "cannot be opened"};
  std::string text{std::istreambuf_iterator<char>{in}, {}};
  if (text.empty()) return Refusal{file, "is empty"};
  return text;
}

bool parse_number(const std::string& field, double& value) {
  char* end = nullptr;
  value = std::strtod(field.c_str(), &end);
  while (*end == ' ' || *end == '\r') ++end;
  return end != field.c_str() && *end == '\0' && !std::isinf(value);
}

Read<std::vector<std::vector<double>>> read_csv(const std::filesystem::path& file,
                                                std::size_t columns, std::size_t time_column,
                                                bool gaps) {
  const Read<std::string> text = read_text(file);
  if (text.has_error()) return text.error();
  std::istringstream lines{*text};
  std::vector<std::vector<double>> rows;
  std::string line, field;
  for (std::size_t number = 1; std::getline(lines, line); ++number) {
    std::vector<double> row;
    std::istringstream fields{line};
    while (std::getline(fields, field, ',')) {
      double value = 0;
      if (!parse_number(field, value)) return Refusal{file, number, "not a number: " + field};
      if (std::isnan(value) && (!gaps || row.size() == time_column))
        return Refusal{file, number, "nan where a number is needed"};
      row.push_back(value);
    }
    if (row.size() != columns)
      return Refusal{file, number,
                     std::to_string(row.size()) + " fields, expected " + std::to_string(columns)};
    if (!rows.empty() && row[time_column] < rows.back()[time_column])
      return Refusal{file, number, "time runs backwards"};
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace drydock::navigation::test
