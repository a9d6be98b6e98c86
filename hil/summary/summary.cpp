#include "hil/summary/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "drivers/text/json_of_any_text.hpp"
#include "drivers/text/printable.hpp"
#include "hil/summary/findings.hpp"
#include "hil/summary/findings_json.hpp"
#include "hil/summary/judge.hpp"
#include "hil/summary/loop_report.hpp"
#include "hil/summary/or_none.hpp"
#include "hil/summary/program_verdict.hpp"

namespace drydock::summary {
namespace {

using Json = nlohmann::ordered_json;

Json error_json(const std::optional<AttitudeError>& e) {
  if (!e) return nullptr;
  return {{"roll_rms_deg", e->roll_rms_deg}, {"pitch_rms_deg", e->pitch_rms_deg},
          {"roll_max_deg", e->roll_max_deg}, {"pitch_max_deg", e->pitch_max_deg},
          {"nees_mean", e->nees_mean},       {"settling_s", e->settling_s}};
}

Json navigation_json(const NavigationError& e) {
  return {{"horizontal_rms_m", e.horizontal_rms_m}, {"horizontal_max_m", e.horizontal_max_m},
          {"horizontal_end_m", e.horizontal_end_m}, {"depth_rms_m", e.depth_rms_m},
          {"velocity_rms_mps", e.velocity_rms_mps}, {"velocity_max_mps", e.velocity_max_mps},
          {"roll_rms_deg", e.roll_rms_deg},         {"pitch_rms_deg", e.pitch_rms_deg},
          {"heading_rms_deg", e.heading_rms_deg},   {"nees_position", e.nees_position}};
}

std::string navigation_text(const NavigationError& e) {
  return fmt::format(
      ", error against truth: position {} RMS, {} at most, {} at the end, velocity {} RMS, roll "
      "{}, "
      "pitch {}, heading {} RMS, NEES {}\n",
      or_none(e.horizontal_rms_m, 2, " m"), or_none(e.horizontal_max_m, 2, " m"),
      or_none(e.horizontal_end_m, 2, " m"), or_none(e.velocity_rms_mps, 4, " m/s"),
      or_none(e.roll_rms_deg, 4), or_none(e.pitch_rms_deg, 4),
      or_none(e.heading_rms_deg, 4, " deg"), or_none(e.nees_position, 2));
}

Json in_json(std::uint64_t count) { return count; }
Json in_json(double number) { return number; }
Json in_json(const std::optional<double>& number) { return number ? Json(*number) : Json(nullptr); }
Json in_json(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

Json device_json(const DeviceSummary& device) {
  Json json;
  visit_fields(device, [&](const char* key, const auto& value) { json[key] = in_json(value); });
  return json;
}

Json verdict_json(const Verdict& v) {
  return {{"of", v.subject},        {"what", v.what},     {"measured", v.measured},
          {"expected", v.expected}, {"passed", v.passed}, {"line", v.line}};
}

Json fault_json(const FaultSummary& f) {
  return {{"device", f.device},
          {"fault", f.words},
          {"since_s", f.since_s},
          {"until_s", f.until_s ? Json(*f.until_s) : Json(nullptr)}};
}

/// One line per fault, up to a number that a person can read.
std::string faults_text(const std::vector<FaultSummary>& faults) {
  constexpr std::size_t most_lines = 20;
  std::string out;
  for (std::size_t i = 0; i < std::min(faults.size(), most_lines); ++i) {
    const FaultSummary& f = faults[i];
    out += fmt::format("fault {:.3f} s to {}: {}\n", f.since_s,
                       f.until_s ? fmt::format("{:.3f} s", *f.until_s) : "the end", f.words);
  }
  if (faults.size() > most_lines)
    out += fmt::format("and {} faults more (--json has all)\n", faults.size() - most_lines);
  return out;
}

Json resident_json(const ResidentTrace& resident) {
  if (resident.megabytes.empty()) return nullptr;
  return {{"start_mb", resident.megabytes.front()},
          {"end_mb", resident.megabytes.back()},
          {"largest_mb", std::ranges::max(resident.megabytes)}};
}

}  // namespace

bool Summary::all_streaming() const {
  return std::all_of(devices.begin(), devices.end(),
                     [](const auto& d) { return d.state == "streaming"; });
}

std::string to_json(const Summary& s) {
  Json root{{"rig", s.rig},
            {"mode", s.mode},
            {"seed", s.seed},
            {"duration_s", s.duration_s},
            {"wall_s", s.wall_s},
            {"times_real_time", s.speed()},
            {"interrupted", s.interrupted},
            {"resident", resident_json(s.resident)},
            {"notes", s.notes},
            {"faults", Json::array()},
            {"findings", findings_json(s.findings)},
            {"expectations", Json::array()},
            {"devices", Json::array()},
            {"estimators", Json::array()}};
  for (const auto& f : s.faults) root["faults"].push_back(fault_json(f));
  for (const auto& v : s.verdicts) root["expectations"].push_back(verdict_json(v));
  for (const auto& d : s.devices) root["devices"].push_back(device_json(d));
  for (const auto& e : s.estimators) {
    root["estimators"].push_back(
        {{"name", e.name},
         {"kind", e.kind},
         {"estimates", e.estimates},
         {"rejected", e.rejected},
         {"valid_share", e.valid_share ? Json(*e.valid_share) : Json(nullptr)},
         {"nis", e.nis ? Json(*e.nis) : Json(nullptr)},
         {"rate_hz", in_json(e.rate_hz)},
         {"whole_run", error_json(e.whole_run)},
         {"after_10_s", error_json(e.after_10_s)}});
    if (e.navigation) root["estimators"].back()["navigation"] = navigation_json(*e.navigation);
    if (e.program) root["estimators"].back()["program"] = program_json(*e.program);
  }
  if (s.loop) root["loop"] = loop_json(*s.loop);
  return text::json_of_any_text(root) + "\n";
}

std::string to_text(const Summary& s) {
  std::size_t name = 10;
  for (const auto& d : s.devices) name = std::max(name, d.name.size());
  std::string out = fmt::format("{:<{}} {:<10} {:<9} {:>9} {:>9} {:>10} {:>9} {:>8} {:>6}\n",
                                "device", name, "state", "source", "rate", "nominal", "messages",
                                "skipped B", "bad sums", "reopen");
  for (const auto& d : s.devices) {
    out += fmt::format("{:<{}} {:<10} {:<9} {:>6.2f} Hz {:>6.2f} Hz {:>10} {:>9} {:>8} {:>6}\n",
                       d.name, name, d.state, d.provenance, d.rate_hz, d.nominal_rate_hz,
                       d.messages, d.bytes_skipped, d.bad_checksums, d.reopens);
    if (!d.left_out.empty())
      out += fmt::format("           left out: {} values, such as: {}\n", d.refused,
                         text::printable(d.left_out));
    if (!d.last_error.empty())
      out += fmt::format("           last error: {}\n", text::printable(d.last_error));
  }
  for (const auto& e : s.estimators) {
    out += fmt::format("{} ({}): {} estimates", e.name, e.kind, e.estimates);
    if (e.valid_share) out += fmt::format(", valid {:.1f} %", 100 * *e.valid_share);
    if (e.nis) out += fmt::format(", NIS {:.2f}", *e.nis);
    if (e.program) out += program_text(*e.program);
    if (e.navigation) {
      out += navigation_text(*e.navigation);
      continue;
    }
    if (e.whole_run) {
      out += fmt::format(", error against truth: roll {:.3f} deg RMS, pitch {:.3f} deg RMS",
                         e.whole_run->roll_rms_deg, e.whole_run->pitch_rms_deg);
      if (e.program && !std::isnan(e.whole_run->nees_mean))
        out += fmt::format(", NEES {:.2f}", e.whole_run->nees_mean);
    }
    if (e.after_10_s) {
      out += fmt::format(" (after 10 s: {:.3f}, {:.3f})", e.after_10_s->roll_rms_deg,
                         e.after_10_s->pitch_rms_deg);
    }
    out += '\n';
  }
  out += faults_text(s.faults) + findings_text(s.findings);
  if (s.loop) out += loop_text(*s.loop);
  for (const auto& note : s.notes) out += note + '\n';
  return out + to_text(s.verdicts);
}

}  // namespace drydock::summary
