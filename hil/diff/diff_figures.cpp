#include "hil/diff/diff_figures.hpp"

#include <algorithm>
#include <array>

#include "hil/summary/findings.hpp"

namespace drydock::diff {
namespace {

using report::Curve;
using report::Figure;
using summary::Summary;

/// The curves of both, each with its letter, and the shades of neither.
Figure both(const Figure& a, const Figure& b) {
  Figure figure = a;
  figure.curves.clear();
  figure.shades.clear();
  const std::array sides{std::pair{&a, "A"}, std::pair{&b, "B"}};
  for (const auto& [side, letter] : sides)
    for (Curve curve : side->curves) {
      curve.label += curve.label.empty() ? letter : std::string(", ") + letter;
      figure.curves.push_back(std::move(curve));
    }
  return figure;
}

Figure map(const std::string& title, const std::vector<double>& east,
           const std::vector<double>& north) {
  Figure figure{title, "east of the start [m]", "north of the start [m]", {{"", east, north}}};
  figure.equal_scales = true;
  return figure;
}

Figure over_time(const std::string& title, const std::string& unit, const std::vector<double>& t_s,
                 const std::vector<double>& value) {
  return {title, "time [s]", unit, {{"", t_s, value}}};
}

void add_motion(const Summary& a, const Summary& b, std::vector<Figure>& figures) {
  if (a.motion.t_s.empty() || b.motion.t_s.empty()) return;
  const auto track = [](const Summary& s) {
    return map("Track of the truth", s.motion.east_m, s.motion.north_m);
  };
  const auto depth = [](const Summary& s) {
    Figure figure =
        over_time("Depth of the truth", "m below the surface", s.motion.t_s, s.motion.depth_m);
    figure.y_down = true;
    return figure;
  };
  figures.push_back(both(track(a), track(b)));
  figures.push_back(both(depth(a), depth(b)));
}

/// Index of the estimator of this name; the number of estimators if there is none.
std::size_t index_of(const Summary& s, const std::string& name) {
  return static_cast<std::size_t>(
      std::ranges::find(s.estimators, name, &summary::EstimatorSummary::name) -
      s.estimators.begin());
}

std::vector<Figure> estimator_figures(const Summary& s, std::size_t i) {
  const auto& name = s.estimators[i].name;
  const auto& navigation = s.navigation[i];
  const auto& attitude = s.traces[i];
  return {
      map(name + ": track", navigation.east_m, navigation.north_m),
      over_time(name + ": position north, error", "m", navigation.t_s, navigation.north_error_m),
      over_time(name + ": position east, error", "m", navigation.t_s, navigation.east_error_m),
      over_time(name + ": roll", "deg", attitude.t_s, attitude.roll_deg),
      over_time(name + ": pitch", "deg", attitude.t_s, attitude.pitch_deg)};
}

bool has_points(const Figure& figure) {
  return std::ranges::any_of(figure.curves, [](const Curve& curve) { return !curve.y.empty(); });
}

void add_pairs(const std::vector<Figure>& a, const std::vector<Figure>& b,
               std::vector<Figure>& figures) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (has_points(a[i]) && has_points(b[i])) figures.push_back(both(a[i], b[i]));
}

}  // namespace

std::vector<Figure> figures_of(const Summary& a, const Summary& b) {
  std::vector<Figure> figures;
  add_motion(a, b, figures);
  for (std::size_t i = 0; i < a.estimators.size(); ++i)
    if (const auto k = index_of(b, a.estimators[i].name); k < b.estimators.size())
      add_pairs(estimator_figures(a, i), estimator_figures(b, k), figures);
  for (const auto& trace : a.measurements) {
    const auto same =
        std::ranges::find(b.measurements, trace.title, &summary::MeasurementTrace::title);
    if (same == b.measurements.end()) continue;
    add_pairs({summary::figure_of(trace, {}, a.duration_s)},
              {summary::figure_of(*same, {}, b.duration_s)}, figures);
  }
  return figures;
}

}  // namespace drydock::diff
