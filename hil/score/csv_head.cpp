#include "hil/score/csv_head.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "drivers/text/printable.hpp"

namespace drydock::score {
namespace {

/// What a person reads of a file that may be anything: not more than a few lines.
std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t most = 300;
  const std::string all = fmt::format("{}", fmt::join(names, ", "));
  return text::printable(all.size() <= most ? all : all.substr(0, most) + " ...");
}

}  // namespace

std::vector<std::string> csv_cells(std::string_view line) {
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == ',') {
      cells.emplace_back();
    } else if (c != ' ' && c != '"' && c != '\r') {
      cells.back().push_back(c);
    }
  }
  return cells;
}

CsvHead::CsvHead(std::string_view line) : names_(csv_cells(line)) {}

bool CsvHead::has(std::string_view name) const {
  return std::ranges::find(names_, name) != names_.end();
}

bool CsvHead::has(const CsvGroup& group) const {
  return std::ranges::all_of(group, [this](const char* name) { return has(name); });
}

std::size_t CsvHead::at(std::string_view name) const {
  return static_cast<std::size_t>(std::ranges::find(names_, name) - names_.begin());
}

std::string CsvHead::misfit() const {
  for (const auto& name : names_)
    if (!name.empty() && std::ranges::count(names_, name) > 1)
      return fmt::format("two columns are named {}", listed({name}));
  if (!has("t_s") && !has("valid_at_ns"))
    return fmt::format("no column t_s or valid_at_ns; there are: {}", listed(names_));
  if (!has(csv_geodetic) && !has(csv_local))
    return fmt::format(
        "no columns latitude_deg, longitude_deg, height_m, or north_m, east_m, down_m; there are: "
        "{}",
        listed(names_));
  return {};
}

std::vector<std::string> CsvHead::incomplete() const {
  std::vector<std::string> notes;
  for (const auto& group : {csv_angles, csv_sigmas})
    for (const char* name : group)
      if (has(name) && !has(group))
        notes.push_back(fmt::format("column {} is not read: it needs {}, all three", name,
                                    fmt::join(group, ", ")));
  return notes;
}

}  // namespace drydock::score
