#include <fmt/format.h>

#include <cmath>

#include "hil/compare/comparison.hpp"
#include "hil/compare/comparison_table.hpp"
#include "hil/report/html.hpp"

namespace drydock::compare {
namespace {

using report::Curve;
using report::Figure;
using Values = std::vector<double>;

void add(Curve& curve, const frame::Position& origin, const std::vector<frame::Position>& places) {
  for (const auto& place : places) {
    const auto offset = frame::ned_offset(origin, place);
    curve.x.push_back(offset.y());
    curve.y.push_back(offset.x());
  }
}

Figure map_of(const Comparison& comparison) {
  Figure map{"Map", "east [m]", "north [m]", {}};
  map.equal_scales = true;
  std::vector<std::pair<std::string, std::vector<frame::Position>>> ways;
  if (!comparison.true_places.empty()) ways.emplace_back("truth", comparison.true_places);
  for (const auto& entry : comparison.entries)
    if (!entry.places.empty()) ways.emplace_back(entry.choice, entry.places);
  for (const auto& [label, places] : ways) {
    map.curves.push_back({label, {}, {}});
    add(map.curves.back(), ways.front().second.front(), places);
  }
  return map;
}

Values difference(const Values& estimate, const Values& truth) {
  Values errors;
  for (std::size_t i = 0; i < truth.size(); ++i) errors.push_back(estimate[i] - truth[i]);
  return errors;
}

Values length(const Values& north, const Values& east) {
  Values lengths;
  for (std::size_t i = 0; i < north.size(); ++i) lengths.push_back(std::hypot(north[i], east[i]));
  return lengths;
}

/// One curve for each estimator that has values.
template <class Of>
std::string figure(std::string title, std::string unit, const Comparison& comparison, Of&& of) {
  Figure plot{std::move(title), "time [s]", std::move(unit), {}};
  for (const auto& entry : comparison.entries) {
    auto [t, value] = of(entry);
    if (!value.empty()) plot.curves.push_back({entry.choice, std::move(t), std::move(value)});
  }
  return plot.curves.empty() ? std::string{} : report::html::figure(plot);
}

std::string attitude_figures(const Comparison& comparison) {
  using Pair = std::pair<Values, Values>;
  const std::string what = comparison.truth ? ": estimate - truth" : "";
  return figure("Roll" + what, "deg", comparison,
                [&](const Entry& e) {
                  const auto& a = e.attitude;
                  return comparison.truth ? Pair{a.t_s, difference(a.roll_deg, a.true_roll_deg)}
                                          : Pair{a.t_s, a.roll_deg};
                }) +
         figure("Pitch" + what, "deg", comparison, [&](const Entry& e) {
           const auto& a = e.attitude;
           return comparison.truth ? Pair{a.t_s, difference(a.pitch_deg, a.true_pitch_deg)}
                                   : Pair{a.t_s, a.pitch_deg};
         });
}

}  // namespace

std::string to_html(const Comparison& comparison) {
  std::string body = report::to_html(table_of(comparison));
  for (const auto& note : notes_of(comparison))
    body += "<p>" + report::html::escaped(note) + "</p>\n";
  const auto map = map_of(comparison);
  if (!map.curves.empty()) body += report::html::figure(map);
  body += figure("Horizontal error", "m", comparison, [](const Entry& e) {
    const auto& n = e.navigation;
    return std::pair{n.t_s, length(n.north_error_m, n.east_error_m)};
  });
  body += attitude_figures(comparison);
  return report::html::page("Estimators on " + comparison.source, body);
}

}  // namespace drydock::compare
