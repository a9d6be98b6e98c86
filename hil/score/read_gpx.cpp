#include <fmt/format.h>

#include <iterator>

#include "drivers/measurement/units.hpp"
#include "hil/score/geodetic_place.hpp"
#include "hil/score/numbers.hpp"
#include "hil/score/passed_over.hpp"
#include "hil/score/read_estimates.hpp"

namespace drydock::score {
namespace {

using Text = std::string_view;

/// What stands between `before` and `after`; empty without one of them.
Text between(Text text, Text before, Text after) {
  const auto first = text.find(before);
  if (first == Text::npos) return {};
  text.remove_prefix(first + before.size());
  const auto end = text.find(after);
  return end == Text::npos ? Text{} : text.substr(0, end);
}

Text without_blanks(Text text) {
  constexpr const char* blanks = " \t\r\n";
  const auto first = text.find_first_not_of(blanks);
  if (first == Text::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

/// XML allows both sorts of quotation marks.
std::optional<double> attribute(Text tag, Text name) {
  for (const char mark : {'"', '\''})
    if (const Text value = between(tag, fmt::format(" {}={}", name, mark), Text(&mark, 1));
        !value.empty())
      return number_of(without_blanks(value));
  return {};
}

struct Point {
  std::optional<double> latitude_deg, longitude_deg, height_m;
  Text time;
};

Point point_of(Text text) {
  std::string tag(text.substr(0, text.find('>')));
  for (char& c : tag)
    if (c == '\n' || c == '\r' || c == '\t') c = ' ';
  return {attribute(tag, "lat"), attribute(tag, "lon"),
          number_of(without_blanks(between(text, "<ele>", "</ele>"))),
          without_blanks(between(text, "<time>", "</time>"))};
}

}  // namespace

boost::system::result<Estimates, Problem> read_gpx(std::istream& in, const std::string& name,
                                                   const frame::Position& origin) {
  const std::string all{std::istreambuf_iterator<char>(in), {}};
  Estimates out;
  PassedOver passed_over("point");
  std::uint64_t number = 0;
  constexpr Text begin = "<trkpt";
  for (auto at = all.find(begin); at != std::string::npos;) {
    const auto next = all.find(begin, at + begin.size());
    const Point point = point_of(Text(all).substr(at, next - at));
    at = next;
    ++number;
    const auto time = stamp_of_any(point.time);
    if (!point.latitude_deg || !point.longitude_deg || std::abs(*point.latitude_deg) > 90 ||
        std::abs(*point.longitude_deg) > 360)
      return Problem{
          fmt::format("{}: point {} of the track has no latitude and longitude", name, number)};
    if (!time) {
      passed_over.add(point.time.empty() ? "a point without a time is left out"
                                         : "the time of a point is none, it is left out",
                      number);
      continue;
    }
    State state;
    state.at = *time;
    state.position_ned =
        place_of({*point.latitude_deg * units::degree, *point.longitude_deg * units::degree,
                  point.height_m.value_or(untold().x())},
                 origin);
    out.track.push_back(state);
  }
  if (number == 0) return Problem{fmt::format("{}: no points of a track (<trkpt>)", name)};
  out.notes = passed_over.notes();
  return out;
}

}  // namespace drydock::score
