#include "hil/calibrate/outcome.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "drivers/text/json_of_any_text.hpp"
#include "estimators/smoothing/level_smoother.hpp"
#include "estimators/smoothing/tilt_smoother.hpp"
#include "hil/calibrate/outcome_words.hpp"
#include "hil/calibrate/residual_change.hpp"
#include "hil/track/outcome.hpp"
#include "hil/track/setup.hpp"

namespace drydock::calibrate {
namespace {

using calibration::Finding;
using smoothing::Quantity;
using Json = nlohmann::ordered_json;

std::string line_of(const Outcome& outcome, const Finding& f) {
  const auto why = why_of(outcome, f);
  const auto unit = shown_unit(f);
  return fmt::format("  {} {:+.4f} +- {:.4f}{} (95 %), {}{}\n", full_name(outcome, f),
                     shown(f, f.value), shown(f, f.bound()), unit.empty() ? "" : " " + unit,
                     verdict_text(f.verdict), why.empty() ? "" : ": " + why);
}

Json finding_json(const Outcome& outcome, const Finding& f) {
  return {{"device", outcome.gathered.device_name(f.parameter.device)},
          {"parameter", name_of(f.parameter.unknown)},
          {"unit", unit_of(f.parameter.unknown)},
          {"value", f.value},
          {"sigma", f.sigma},
          {"bound_95", f.bound()},
          {"prior_sigma", f.parameter.prior_sigma},
          {"verdict", verdict_text(f.verdict)},
          {"why", why_of(outcome, f)}};
}

bool is_alone(const smoothing::Dive& dive) {
  const auto& all = dive.readings;
  return std::ranges::all_of(
      all, [&](const auto& reading) { return reading.device == all.front().device; });
}

}  // namespace

Outcome calibrated(track::Gathered gathered) {
  gathered.dive.tilts = smoothing::smooth_tilts(std::move(gathered.dive.tilts));
  if (!track::has(gathered.dive, Quantity::heading))
    throw std::runtime_error("no heading: a compass, or a DVL with its own");
  const auto parameters = calibration::parameters_of(gathered.dive);
  if (!track::has(gathered.dive, Quantity::bottom) && !track::has(gathered.dive, Quantity::log))
    throw std::runtime_error("no bottom track and no log: nothing to calibrate");
  if (is_alone(gathered.dive))
    throw std::runtime_error(
        "one sensor alone: nothing else says how the vehicle moved; a calibration compares it with "
        "fixes, a depth sensor, a compass or a log");
  if (gathered.own_heading)
    gathered.notes.emplace_back(
        "the heading is the DVL's own: yaw is that of its beams against its compass; its mounting "
        "in the vehicle cannot be told");
  if (gathered.own_tilts)
    gathered.notes.emplace_back(
        "roll and pitch are the DVL's own: pitch is that of its beams against its tilt sensors; "
        "its "
        "mounting in the vehicle cannot be told");
  if (gathered.own_depth)
    gathered.notes.emplace_back(
        "the depth is the DVL's own: it is taken as exact but for its noise");
  if (track::has(gathered.dive, Quantity::bottom))
    gathered.notes.emplace_back(
        "the roll of a DVL's mounting is not told: it turns the velocity about the way ahead, and "
        "stays as the rig has it");
  if (gathered.dive.tilts.empty())
    gathered.notes.emplace_back("nothing tells roll and pitch: the vehicle is taken as level");
  const auto options = track::level_of(gathered, {});
  auto found = calibration::calibrate(gathered.dive, options, parameters, gathered.unstated);
  auto as_in_rig = found.options;
  as_in_rig.sensors = options.sensors;
  auto before = smoothing::level_residuals(gathered.dive, as_in_rig);
  auto after = smoothing::level_residuals(gathered.dive, found.options);
  return {std::move(gathered), std::move(found), std::move(before), std::move(after)};
}

std::string to_text(const Outcome& outcome) {
  const auto& c = outcome.calibration;
  std::string out = fmt::format("{}: changes of what the rig says; {}\n", outcome.gathered.source,
                                settled_text(c));
  for (const auto& note : outcome.gathered.notes) out += "  " + note + "\n";
  for (const auto& finding : c.findings) out += line_of(outcome, finding);
  for (std::size_t i = 0; i < c.findings.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (const double r =
              c.correlation(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
          std::abs(r) > 0.5)
        out += fmt::format("  correlation {:+.2f}: {} with {}\n", r,
                           full_name(outcome, c.findings[i]), full_name(outcome, c.findings[j]));
  return out;
}

std::string to_json(const Outcome& outcome) {
  const auto& c = outcome.calibration;
  Json json{{"source", outcome.gathered.source}, {"converged", c.converged},
            {"iterations", c.iterations},        {"notes", outcome.gathered.notes},
            {"findings", Json::array()},         {"correlation", Json::array()},
            {"residuals", Json::array()}};
  for (const auto& finding : c.findings) json["findings"].push_back(finding_json(outcome, finding));
  for (Eigen::Index i = 0; i < c.correlation.rows(); ++i) {
    const Eigen::VectorXd row = c.correlation.row(i);
    json["correlation"].push_back(std::vector<double>(row.begin(), row.end()));
  }
  for (const auto& change : residual_changes(outcome))
    json["residuals"].push_back({{"device", outcome.gathered.device_name(change.device)},
                                 {"quantity", track::name_of(change.quantity)},
                                 {"unit", track::unit_of(change.quantity)},
                                 {"rms_before", change.rms_before},
                                 {"rms_after", change.rms_after},
                                 {"nis_before", change.nis_before},
                                 {"nis_after", change.nis_after}});
  return text::json_of_any_text(json) + "\n";
}

}  // namespace drydock::calibrate
