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

CsvHead::CsvHead(std::string_view line) : names_(csv_cells(line)) {
  constexpr std::array<std::pair<const char*, const char*>, 6> also{
      {{"yaw_deg", "heading_deg"},
       {"altitude_m", "height_m"},
       {"sigma_north_m", "north_sigma_m"},
       {"sigma_east_m", "east_sigma_m"},
       {"sigma_height_m", "down_sigma_m"},
       {"sigma_heading_deg", "heading_sigma_deg"}}};
  for (const auto& [other, name] : also) std::ranges::replace(names_, other, name);
}

bool CsvHead::has(std::string_view name) const {
  return std::ranges::find(names_, name) != names_.end();
}

bool CsvHead::has_any(const CsvGroup& group) const {
  return std::ranges::any_of(group, [this](const char* name) { return has(name); });
}

bool CsvHead::has_quaternion() const {
  return std::ranges::all_of(csv_quaternion, [this](const char* name) { return has(name); });
}

std::size_t CsvHead::at(std::string_view name) const {
  return static_cast<std::size_t>(std::ranges::find(names_, name) - names_.begin());
}

std::string CsvHead::misfit() const {
  for (const auto& name : names_)
    if (!name.empty() && std::ranges::count(names_, name) > 1)
      return fmt::format("two columns are named {}", listed({name}));
  if (std::ranges::none_of(csv_times, [this](const char* name) { return has(name); }))
    return fmt::format("no column {}; there are: {}", fmt::join(csv_times, " or "), listed(names_));
  if (!has_geodetic() && !has(csv_geodetic[2]) && !has_any(csv_local) && !has_any(csv_angles) &&
      !has_quaternion() && !has_any(csv_velocity) && !has_any(csv_body_velocity))
    return fmt::format(
        "no column of a position, an attitude or a velocity: {}, {}, {}, {}, {}, {}; there are: {}",
        fmt::join(csv_geodetic, ", "), fmt::join(csv_local, ", "), fmt::join(csv_angles, ", "),
        fmt::join(csv_quaternion, ", "), fmt::join(csv_velocity, ", "),
        fmt::join(csv_body_velocity, ", "), listed(names_));
  return {};
}

std::vector<std::string> CsvHead::incomplete() const {
  std::vector<std::string> notes;
  const auto note = [&](const char* name, const auto& needed) {
    notes.push_back(
        fmt::format("column {} is not read: it needs all of {}", name, fmt::join(needed, ", ")));
  };
  const std::array places{csv_geodetic[0], csv_geodetic[1]};
  for (const char* name : places)
    if (has(name) && !has_geodetic()) note(name, places);
  for (const char* name : csv_quaternion)
    if (has(name) && !has_quaternion()) note(name, csv_quaternion);
  if (has_any(csv_body_velocity) && has_any(csv_velocity))
    notes.push_back(fmt::format("columns {} are not read: the velocity is that of {}",
                                fmt::join(csv_body_velocity, ", "), fmt::join(csv_velocity, ", ")));
  return notes;
}

}  // namespace drydock::score
