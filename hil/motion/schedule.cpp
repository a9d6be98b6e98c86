#include "hil/motion/schedule.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "drivers/measurement/units.hpp"

namespace drydock::motion {

namespace {

constexpr std::string_view header = "t,rudder,stern,bow,rpm";
constexpr std::size_t columns = 5;

std::string_view without_line_end(std::string_view line) {
  while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
  return line;
}

std::array<double, columns> numbers(std::string_view line, const std::string& place) {
  std::array<double, columns> values{};
  for (std::size_t i = 0; i < columns; ++i) {
    const auto comma = line.find(',');
    const std::string_view field = line.substr(0, comma);
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), values[i]);
    if (error != std::errc{} || end != field.data() + field.size() || !std::isfinite(values[i]))
      throw BadSchedule(place + "'" + std::string(field) + "' is no number");
    if ((comma == line.npos) != (i + 1 == columns))
      throw BadSchedule(place + "5 numbers are needed: " + std::string(header));
    line.remove_prefix(comma == line.npos ? line.size() : comma + 1);
  }
  return values;
}

}  // namespace

Schedule parse_schedule(std::string_view text, const std::string& file) {
  Schedule schedule;
  for (int number = 1; !text.empty(); ++number) {
    const auto end = text.find('\n');
    const auto line = without_line_end(text.substr(0, end));
    text.remove_prefix(end == text.npos ? text.size() : end + 1);
    const std::string place = file + ":" + std::to_string(number) + ": ";
    if (number == 1) {
      if (line != header) throw BadSchedule(place + "the header must be " + std::string(header));
      continue;
    }
    if (line.empty()) continue;
    const auto [t, rudder, stern, bow, turns] = numbers(line, place);
    if (schedule.empty() ? t != 0 : t <= schedule.back().t)
      throw BadSchedule(place + "times must begin with 0 and increase");
    schedule.push_back({t, rudder * units::degree, stern * units::degree, bow * units::degree,
                        turns * units::revolution_per_minute});
  }
  if (schedule.empty()) throw BadSchedule(file + ": no row; the first must be at t = 0");
  return schedule;
}

Command command_at(const Schedule& schedule, double t, double advance_m) {
  constexpr double rounding_s = 1e-9;  // for times that are multiples of a step
  const auto next = std::ranges::upper_bound(schedule, t + rounding_s, {}, &ScheduleEntry::t);
  const ScheduleEntry& now = *std::prev(next);
  return {now.rudder_rad, now.stern_rad, now.bow_rad, now.propeller_radps * advance_m};
}

}  // namespace drydock::motion
