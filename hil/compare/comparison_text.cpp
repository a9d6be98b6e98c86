#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "drivers/text/json_of_any_text.hpp"
#include "hil/compare/comparison.hpp"
#include "hil/compare/comparison_table.hpp"

namespace drydock::compare {
namespace {

using Json = nlohmann::ordered_json;

/// JSON has no NaN.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json number(const std::optional<double>& value) { return value ? number(*value) : Json(); }

Json attitude_json(const summary::AttitudeError& e) {
  return {{"roll_rms_deg", number(e.roll_rms_deg)},
          {"roll_max_deg", number(e.roll_max_deg)},
          {"pitch_rms_deg", number(e.pitch_rms_deg)},
          {"pitch_max_deg", number(e.pitch_max_deg)},
          {"nees", number(e.nees_mean)}};
}

Json position_json(const summary::NavigationError& e) {
  return {{"horizontal_rms_m", number(e.horizontal_rms_m)},
          {"horizontal_max_m", number(e.horizontal_max_m)},
          {"horizontal_end_m", number(e.horizontal_end_m)},
          {"depth_rms_m", number(e.depth_rms_m)},
          {"velocity_rms_mps", number(e.velocity_rms_mps)},
          {"velocity_max_mps", number(e.velocity_max_mps)},
          {"heading_rms_deg", number(e.heading_rms_deg)},
          {"nees", number(e.nees_position)}};
}

Json entry_json(const Entry& entry) {
  const auto& s = entry.summary;
  Json json{{"estimator", entry.choice},
            {"kind", s.kind},
            {"estimates", s.estimates},
            {"rate_hz", number(s.rate_hz)},
            {"valid_share", number(s.valid_share)},
            {"gaps", entry.gaps.count},
            {"longest_gap_s", entry.gaps.longest_s},
            {"used", entry.used},
            {"rejected", s.rejected},
            {"nis", number(s.nis)},
            {"cpu_s", entry.cpu_s},
            {"cost_us", number(entry.cost_us())},
            {"notes", entry.notes}};
  if (s.whole_run) json["attitude"] = attitude_json(*s.whole_run);
  if (s.navigation) json["position"] = position_json(*s.navigation);
  if (s.program) json["answer_ms"] = 1e3 * s.program->mean_s;
  return json;
}

}  // namespace

std::string to_text(const Comparison& comparison) {
  std::string out = report::to_text(table_of(comparison));
  for (const auto& note : notes_of(comparison)) out += note + "\n";
  return out;
}

std::string to_json(const Comparison& comparison) {
  Json json{{"source", comparison.source},
            {"duration_s", comparison.duration_s},
            {"measurements", comparison.measurements},
            {"truth", comparison.truth},
            {"notes", comparison.notes},
            {"estimators", Json::array()}};
  for (const auto& entry : comparison.entries) json["estimators"].push_back(entry_json(entry));
  return text::json_of_any_text(json) + "\n";
}

}  // namespace drydock::compare
