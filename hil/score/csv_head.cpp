#include "hil/score/csv_head.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "drivers/text/printable.hpp"
#include "hil/score/csv_covariance.hpp"

namespace drydock::score {
namespace {

/// What a person reads of a file that may be anything: not more than a few lines.
std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t most = 300;
  const std::string all = fmt::format("{}", fmt::join(names, ", "));
  return text::printable(all.size() <= most ? all : all.substr(0, most) + " ...");
}

template <class Names>
bool among(const Names& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

bool is_known(const std::string& name) {
  constexpr std::array groups{csv_geodetic,     csv_local,           csv_angles,
                              csv_velocity,     csv_body_velocity,   csv_local_sigmas,
                              csv_angle_sigmas, csv_velocity_sigmas, csv_body_velocity_sigmas};
  return is_covariance_column(name) || among(csv_times, name) || among(csv_other_times, name) ||
         among(csv_quaternion, name) || among(csv_enu_quaternion, name) ||
         name == csv_correlation ||
         std::ranges::any_of(groups, [&](const CsvGroup& group) { return among(group, name); });
}

}  // namespace

CsvHead::CsvHead(std::vector<std::string> written) : written_(std::move(written)) {
  for (const std::string& name : written_) columns_.push_back({name});
  for (std::size_t i = 0; i < columns_.size(); ++i)
    if (auto column = column_named(written_[i]); !has(column.name)) columns_[i] = std::move(column);
  // A quaternion without a sign of its axes has those of the position beside it.
  const auto is_axis = [](const std::string& name) {
    return name == "x" || name == "y" || name == "z" || name == "tx" || name == "ty" ||
           name == "tz";
  };
  if (std::ranges::none_of(written_, is_axis)) return;
  for (std::size_t i = 0; i < csv_quaternion.size(); ++i)
    if (has(csv_quaternion[i]) && !has(csv_enu_quaternion[i]))
      columns_[at(csv_quaternion[i])].name = csv_enu_quaternion[i];
}

bool CsvHead::has(std::string_view name) const {
  return std::ranges::find(columns_, name, &Column::name) != columns_.end();
}

bool CsvHead::has_any(const CsvGroup& group) const {
  return std::ranges::any_of(group, [this](const char* name) { return has(name); });
}

bool CsvHead::has_quaternion() const {
  return std::ranges::all_of(csv_quaternion, [this](const char* name) { return has(name); });
}

bool CsvHead::has_enu_quaternion() const {
  return std::ranges::all_of(csv_enu_quaternion, [this](const char* name) { return has(name); });
}

std::size_t CsvHead::at(std::string_view name) const {
  return static_cast<std::size_t>(std::ranges::find(columns_, name, &Column::name) -
                                  columns_.begin());
}

std::string CsvHead::misfit() const {
  for (const auto& name : written_)
    if (!name.empty() && std::ranges::count(written_, name) > 1)
      return fmt::format("two columns are named {}", listed({name}));
  const auto is_there = [this](const char* name) { return has(name); };
  if (std::ranges::none_of(csv_times, is_there) && std::ranges::none_of(csv_other_times, is_there))
    return fmt::format("no column {}; there are: {}", fmt::join(csv_times, " or "),
                       listed(written_));
  if (!has_geodetic() && !has(csv_geodetic[2]) && !has_any(csv_local) && !has_any(csv_angles) &&
      !has_quaternion() && !has_enu_quaternion() && !has_any(csv_velocity) &&
      !has_any(csv_body_velocity))
    return fmt::format(
        "no column of a position, an attitude or a velocity: {}, {}, {}, {}, {}, {}; there are: {}",
        fmt::join(csv_geodetic, ", "), fmt::join(csv_local, ", "), fmt::join(csv_angles, ", "),
        fmt::join(csv_quaternion, ", "), fmt::join(csv_velocity, ", "),
        fmt::join(csv_body_velocity, ", "), listed(written_));
  return {};
}

std::vector<std::string> CsvHead::notes() const {
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
  if (const auto names = unknown(); !names.empty())
    notes.push_back(fmt::format("{} column{} not read: {}", names.size(),
                                names.size() == 1 ? " is" : "s are", listed(names)));
  return notes;
}

std::vector<std::string> CsvHead::unknown() const {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < columns_.size(); ++i)
    if (!written_[i].empty() && !is_known(columns_[i].name)) names.push_back(written_[i]);
  return names;
}

}  // namespace drydock::score
