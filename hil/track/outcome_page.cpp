#include <fmt/format.h>

#include <cmath>

#include "hil/report/html.hpp"
#include "hil/report/table.hpp"
#include "hil/track/outcome.hpp"

namespace drydock::track {
namespace {

using report::Curve;
using report::Figure;
using smoothing::Quantity;
using smoothing::TrackPoint;

constexpr std::size_t most_points = 3000;  ///< of a curve

std::size_t stride_of(std::size_t count) { return count / most_points + 1; }

/// Positions as east and north of the track's begin.
class Chart {
 public:
  explicit Chart(const frame::Position& origin) : origin_(origin) {}

  void add(Curve& curve, const frame::Position& position) const {
    const auto offset = frame::ned_offset(origin_, position);
    curve.x.push_back(offset.y());
    curve.y.push_back(offset.x());
  }

 private:
  frame::Position origin_;
};

Curve curve_of(const Chart& chart, const std::string& label,
               const std::vector<TrackPoint>& points) {
  Curve curve{label, {}, {}};
  for (std::size_t k = 0; k < points.size(); k += stride_of(points.size()))
    chart.add(curve, points[k].position);
  return curve;
}

Figure map_of(const Outcome& outcome) {
  const Chart chart(outcome.track.smoothed.front().position);
  Figure map{"Map", "east, m", "north, m", {}};
  map.equal_scales = true;
  map.curves.push_back(curve_of(chart, "smoother", outcome.track.smoothed));
  map.curves.push_back(curve_of(chart, "filter", outcome.track.filtered));
  Curve truth{"truth", {}, {}}, fixes{"fixes", {}, {}, false, true};
  const auto& gathered = outcome.gathered;
  for (std::size_t k = 0; k < gathered.truth.size(); k += stride_of(gathered.truth.size()))
    chart.add(truth, gathered.truth[k].position);
  for (const auto& reading : gathered.dive.readings)
    if (reading.quantity == Quantity::fix)
      chart.add(fixes, {reading.value.x(), reading.value.y(), 0});
  if (!truth.x.empty()) map.curves.push_back(truth);
  if (!fixes.x.empty()) map.curves.push_back(fixes);
  return map;
}

double horizontal_sigma(const TrackPoint& point) {
  return std::sqrt(point.position_covariance(0, 0) + point.position_covariance(1, 1));
}

Figure sigma_figure(const Outcome& outcome) {
  Figure figure{"Uncertainty of the horizontal position, 1 sigma", "time, s", "m", {}};
  const auto add = [&](const std::string& label, const std::vector<TrackPoint>& points) {
    Curve curve{label, {}, {}};
    for (std::size_t k = 0; k < points.size(); k += stride_of(points.size())) {
      curve.x.push_back(points[k].time_s);
      curve.y.push_back(horizontal_sigma(points[k]));
    }
    figure.curves.push_back(curve);
  };
  add("smoother", outcome.track.smoothed);
  add("filter", outcome.track.filtered);
  figure.log_y = true;  // a filter begins with hundreds of metres
  return figure;
}

Figure height_figure(const Outcome& outcome) {
  const bool is_depth = has(outcome.gathered.dive, smoothing::Quantity::depth);
  Figure figure{is_depth ? "Depth" : "Height",
                "time, s",
                is_depth ? "m below the surface" : "m above the ellipsoid",
                {}};
  figure.y_down = is_depth;
  Curve curve{"smoother", {}, {}};
  const auto& points = outcome.track.smoothed;
  for (std::size_t k = 0; k < points.size(); k += stride_of(points.size())) {
    curve.x.push_back(points[k].time_s);
    curve.y.push_back((is_depth ? -1 : 1) * points[k].position.height_m);
  }
  figure.curves.push_back(curve);
  return figure;
}

Figure residual_figure(const Outcome& outcome, const SensorResiduals& sensor) {
  Figure figure{fmt::format("{}: residuals of {}", sensor.device, name_of(sensor.quantity)),
                "time, s",
                "residual / its sigma",
                {}};
  constexpr const char* axes[] = {"first axis", "second axis", "third axis"};
  for (const char* axis : axes) figure.curves.push_back({axis, {}, {}, false, true});
  const auto& readings = outcome.gathered.dive.readings;
  const std::size_t stride = stride_of(sensor.readings);
  std::size_t seen = 0;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    if (readings[i].quantity != sensor.quantity ||
        outcome.gathered.device_name(readings[i].device) != sensor.device || seen++ % stride != 0)
      continue;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto& residual = outcome.track.residuals[i][axis];
      if (!residual.known) continue;
      figure.curves[axis].x.push_back(readings[i].time_s);
      figure.curves[axis].y.push_back(residual.normalised());
    }
  }
  std::erase_if(figure.curves, [](const Curve& curve) { return curve.x.empty(); });
  return figure;
}

report::Table sensor_table(const Outcome& outcome) {
  report::Table table{"Residuals of the sensors",
                      {"sensor", "readings", "refused", "unused", "RMS", "mean", "sigma", "NIS"},
                      {},
                      "measured minus expected by the filter before the reading; NIS: mean "
                      "normalised square, 1 is consistent"};
  for (const auto& s : outcome.sensors) {
    const auto value = [&](double v) { return fmt::format("{:.3g}", shown(s.quantity, v)); };
    table.rows.push_back(
        {fmt::format("{}, {} [{}]", s.device, name_of(s.quantity), shown_unit(s.quantity)),
         fmt::format("{}", s.readings), fmt::format("{}", s.refused), fmt::format("{}", s.unused),
         value(s.rms), value(s.mean), value(s.sigma) + (s.fitted ? " fitted" : ""),
         fmt::format("{:.2f}", s.nis)});
  }
  return table;
}

}  // namespace

std::string to_html(const Outcome& outcome) {
  std::string body =
      "<pre>" + report::html::escaped(to_text(outcome)) + "</pre>\n" +
      report::html::figure(map_of(outcome)) +
      (outcome.has_heights ? report::html::figure(height_figure(outcome)) : std::string()) +
      report::html::figure(sigma_figure(outcome)) + report::to_html(sensor_table(outcome));
  for (const auto& sensor : outcome.sensors)
    if (sensor.unused < sensor.readings)
      body += report::html::figure(residual_figure(outcome, sensor));
  return report::html::page("Track of " + outcome.gathered.source, body);
}

}  // namespace drydock::track
