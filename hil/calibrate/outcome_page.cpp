#include <fmt/format.h>

#include <cmath>

#include "hil/calibrate/outcome.hpp"
#include "hil/calibrate/outcome_words.hpp"
#include "hil/calibrate/residual_change.hpp"
#include "hil/report/html.hpp"
#include "hil/report/table.hpp"
#include "hil/track/outcome.hpp"

namespace drydock::calibrate {
namespace {

constexpr std::size_t most_points = 3000;  ///< of a curve

report::Table findings_table(const Outcome& outcome) {
  report::Table table{
      "Changes of what the rig says",
      {"parameter", "change", "95 % bound", "1 sigma before the dive", "unit", "verdict"},
      {},
      "the bound holds the true value in 95 % of dives"};
  for (const auto& f : outcome.calibration.findings) {
    const auto value = [&](double v) { return fmt::format("{:.4f}", shown(f, v)); };
    const auto why = why_of(outcome, f);
    table.rows.push_back({full_name(outcome, f), value(f.value), value(f.bound()),
                          value(f.parameter.prior_sigma), shown_unit(f),
                          std::string(verdict_text(f.verdict)) + (why.empty() ? "" : ": " + why)});
  }
  return table;
}

report::Table correlation_table(const Outcome& outcome) {
  const auto& c = outcome.calibration;
  report::Table table{"Correlations", {"parameter"}, {}, ""};
  for (const auto& f : c.findings) {
    table.columns.push_back(full_name(outcome, f));
    std::vector<std::string> row{full_name(outcome, f)};
    for (Eigen::Index j = 0; j < c.correlation.cols(); ++j)
      row.push_back(
          fmt::format("{:+.2f}", c.correlation(static_cast<Eigen::Index>(table.rows.size()), j)));
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string sensor_of(const Outcome& outcome, const ResidualChange& change) {
  return fmt::format("{}, {}", outcome.gathered.device_name(change.device),
                     track::name_of(change.quantity));
}

report::Table residual_table(const Outcome& outcome) {
  report::Table table{
      "Residuals before and after",
      {"sensor", "RMS before", "RMS after", "unit", "NIS before", "NIS after"},
      {},
      "measured minus expected by the filter before the reading, with the sensors "
      "as the rig has them and as they were found; NIS: mean normalised square, 1 is "
      "consistent"};
  for (const auto& change : residual_changes(outcome)) {
    const auto rms = [&](double v) {
      return fmt::format("{:.3g}", track::shown(change.quantity, v));
    };
    table.rows.push_back({sensor_of(outcome, change), rms(change.rms_before), rms(change.rms_after),
                          std::string(track::shown_unit(change.quantity)),
                          fmt::format("{:.2f}", change.nis_before),
                          fmt::format("{:.2f}", change.nis_after)});
  }
  return table;
}

/// Root mean normalised square of the axes of each reading.
report::Figure residual_figure(const Outcome& outcome, const ResidualChange& change) {
  report::Figure figure{
      "Residuals of " + sensor_of(outcome, change), "time, s", "residual / its sigma", {}};
  const auto add = [&](const char* label, const smoothing::Residuals& residuals) {
    report::Curve curve{label, {}, {}, false, true};
    const auto& readings = outcome.gathered.dive.readings;
    const std::size_t stride = readings.size() / most_points + 1;
    std::size_t seen = 0;
    for (std::size_t i = 0; i < readings.size(); ++i) {
      if (readings[i].device != change.device || readings[i].quantity != change.quantity ||
          seen++ % stride != 0)
        continue;
      double squares = 0;
      int count = 0;
      for (const auto& axis : residuals[i]) {
        if (!axis.known) continue;
        squares += axis.normalised() * axis.normalised();
        ++count;
      }
      if (count == 0) continue;
      curve.x.push_back(readings[i].time_s);
      curve.y.push_back(std::sqrt(squares / count));
    }
    figure.curves.push_back(std::move(curve));
  };
  add("before", outcome.before);
  add("after", outcome.after);
  return figure;
}

}  // namespace

std::string to_html(const Outcome& outcome) {
  std::string body = "<p>" + report::html::escaped(settled_text(outcome.calibration)) + "</p>\n";
  for (const auto& note : outcome.gathered.notes)
    body += "<p>" + report::html::escaped(note) + "</p>\n";
  body += report::to_html(findings_table(outcome)) + report::to_html(correlation_table(outcome)) +
          report::to_html(residual_table(outcome));
  for (const auto& change : residual_changes(outcome))
    body += report::html::figure(residual_figure(outcome, change));
  return report::html::page("Calibration of " + outcome.gathered.source, body);
}

}  // namespace drydock::calibrate
