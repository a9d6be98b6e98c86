#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "hil/track/outcome.hpp"

#include "drivers/text/json_of_any_text.hpp"

namespace drydock::track {
namespace {

using smoothing::Quantity;
using Json = nlohmann::ordered_json;

std::string sensor_line(const SensorResiduals& s) {
  const auto value = [&](double v) { return fmt::format("{:.3g}", shown(s.quantity, v)); };
  return fmt::format(
      "  {} {}: {} readings, {} refused, {} unused; residual {} {} RMS, mean {}; "
      "sigma {} ({}), NIS {:.2f}\n",
      s.device, name_of(s.quantity), s.readings, s.refused, s.unused, value(s.rms),
      shown_unit(s.quantity), value(s.mean), value(s.sigma), s.fitted ? "fitted" : "stated", s.nis);
}

Json sensor_json(const SensorResiduals& s) {
  return {{"device", s.device},
          {"quantity", name_of(s.quantity)},
          {"unit", unit_of(s.quantity)},
          {"readings", s.readings},
          {"refused", s.refused},
          {"unused", s.unused},
          {"residual_rms", s.rms},
          {"residual_mean", s.mean},
          {"sigma", s.sigma},
          {"sigma_fitted", s.fitted},
          {"nis", s.nis}};
}

Json truth_json(const TruthFigures& f) {
  return {{"points", f.points},
          {"filter_rms_m", f.filter_rms_m},
          {"smoother_rms_m", f.smoother_rms_m},
          {"smoother_max_m", f.smoother_max_m},
          {"smoother_end_m", f.smoother_end_m},
          {"nees", f.nees}};
}

std::string truth_line(const TruthFigures& f) {
  return fmt::format(
      "against the truth: smoother {:.2f} m RMS, {:.2f} m at most, {:.2f} m at the "
      "end, NEES {:.2f}; filter {:.2f} m RMS\n",
      f.smoother_rms_m, f.smoother_max_m, f.smoother_end_m, f.nees, f.filter_rms_m);
}

}  // namespace

std::string to_text(const Outcome& outcome) {
  std::string out =
      fmt::format("{}: {:.0f} m in {:.1f} s, {}; uncertain by {:.2f} m at most (1 sigma)\n",
                  outcome.gathered.source, outcome.distance_m, outcome.duration_s,
                  outcome.inertial ? "with the IMU" : "without an IMU", outcome.worst_sigma_m);
  for (const auto& note : outcome.notes) out += "  " + note + "\n";
  for (const auto& sensor : outcome.sensors) out += sensor_line(sensor);
  for (const auto& [reason, count] : outcome.gathered.passed_over)
    out += fmt::format("  passed over: {} {}\n", count, reason);
  if (outcome.truth) out += truth_line(*outcome.truth);
  return out;
}

std::string to_json(const Outcome& outcome) {
  Json json{{"source", outcome.gathered.source},
            {"model", outcome.inertial ? "inertial" : "level"},
            {"duration_s", outcome.duration_s},
            {"distance_m", outcome.distance_m},
            {"points", outcome.track.smoothed.size()},
            {"worst_sigma_m", outcome.worst_sigma_m},
            {"notes", outcome.notes},
            {"sensors", Json::array()},
            {"passed_over", outcome.gathered.passed_over}};
  for (const auto& sensor : outcome.sensors) json["sensors"].push_back(sensor_json(sensor));
  if (outcome.truth) json["truth"] = truth_json(*outcome.truth);
  return text::json_of_any_text(json) + "\n";
}

}  // namespace drydock::track
