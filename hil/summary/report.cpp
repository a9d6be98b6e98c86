#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drivers/measurement/units.hpp"
#include "hil/report/html.hpp"
#include "hil/summary/findings.hpp"
#include "hil/summary/loop_report.hpp"
#include "hil/summary/navigation_report.hpp"
#include "hil/summary/or_none.hpp"
#include "hil/summary/program_verdict.hpp"
#include "hil/summary/summary.hpp"

namespace drydock::summary {
namespace {

using report::html::escaped;
using report::html::figure;

std::string last_error_text(const DeviceSummary& d) {
  return fmt::format("{} error{}, the last {:.1f} s before the end: {}", d.errors,
                     d.errors == 1 ? "" : "s", d.last_error_age_s.value_or(0), d.last_error);
}

std::string health_table(const Summary& s) {
  std::string out =
      "<div class=scroll><table><tr><th>device<th class=left>state<th class=left>source"
      "<th class=left>protocol<th>rate<th>nominal<th>messages<th>bytes in<th>in good frames"
      "<th>skipped<th>bad checksums<th>reopened</tr>\n";
  for (const auto& d : s.devices) {
    out += fmt::format(
        "<tr><td>{}<td class='left {}'>{}<td class=left>{}<td class=left>{}<td>{:.2f} Hz<td>{:.2f} "
        "Hz"
        "<td>{}<td>{}<td>{}<td>{}<td>{}<td>{}</tr>\n",
        report::html::escaped(d.name), d.state == "streaming" ? "ok" : "bad", d.state, d.provenance,
        report::html::escaped(d.protocol), d.rate_hz, d.nominal_rate_hz, d.messages, d.bytes_in,
        d.bytes_good, d.bytes_skipped, d.bad_checksums, d.reopens);
  }
  out += "</table></div>\n";
  for (const auto& d : s.devices) {
    out +=
        fmt::format("<p class=soft>{}: <code>{}</code>{}</p>\n", report::html::escaped(d.name),
                    report::html::escaped(d.link),
                    d.last_error.empty() ? "" : " — " + report::html::escaped(last_error_text(d)));
  }
  return out;
}

std::string error_row(const char* span, const AttitudeError& e) {
  return fmt::format("<tr><td>{}<td>{:.3f}°<td>{:.3f}°<td>{:.3f}°<td>{:.3f}°<td>{}<td>{}</tr>\n",
                     span, e.roll_rms_deg, e.pitch_rms_deg, e.roll_max_deg, e.pitch_max_deg,
                     or_none(e.nees_mean, 2), or_none(e.settling_s, 2, " s"));
}

std::string error_table(const EstimatorSummary& e) {
  if (!e.whole_run) {
    return fmt::format("<p>{} estimates; no truth to compare with.</p>", e.estimates);
  }
  std::string out =
      "<div class=scroll><table><tr><th>error against truth<th>roll RMS<th>pitch RMS"
      "<th>roll max<th>pitch max<th>NEES per axis<th>settled after</tr>\n";
  out += error_row("whole run", *e.whole_run);
  if (e.after_10_s) out += error_row("after 10 s", *e.after_10_s);
  return out + "</table></div>\n";
}

/// Whether the estimates said that they may be used, and how far the last one can be off.
std::string integrity_table(const EstimatorSummary& e) {
  if (!e.valid_share || !e.promised) return {};
  const auto& last = *e.promised;
  std::string head = "<th>estimates<th>at the end", row;  // a phone shows the first cell alone
  const auto add = [&](const char* what, double value, const char* unit) {
    head += fmt::format("<th>{} within", what);
    row += fmt::format("<td>{:.2g}{}", value, unit);
  };
  add("roll", last.roll_bound_rad * units::degrees_per_radian, "°");
  add("pitch", last.pitch_bound_rad * units::degrees_per_radian, "°");
  if (last.heading_bound_rad)
    add("heading", *last.heading_bound_rad * units::degrees_per_radian, "°");
  if (last.horizontal_bound_m) add("position", *last.horizontal_bound_m, " m");
  return fmt::format(
      "<div class=scroll><table><tr>{}</tr>\n<tr><td>{:.1f} % of the estimates valid<td>{}{}</tr>"
      "</table></div>\n",
      head, 100 * *e.valid_share, last.valid ? "valid" : "<span class=bad>not valid</span>", row);
}

std::string fault_section(const Summary& s) {
  if (s.faults.empty()) return {};
  std::string out =
      "<h2>Faults</h2>\n<div class=scroll><table><tr><th>fault<th>from<th>until</tr>\n";
  for (const auto& f : s.faults)
    out += fmt::format("<tr><td>{}<td>{:.3f} s<td>{}</tr>\n", report::html::escaped(f.words),
                       f.since_s, f.until_s ? fmt::format("{:.3f} s", *f.until_s) : "the end");
  return out + "</table></div>\n";
}

std::string finding_section(const Summary& s) {
  std::string out = "<h2>Findings</h2>\n" + findings_list(s.findings);
  if (!s.findings.empty())
    out +=
        "<p class=soft>The plots of the measurements have a shade while something was wrong.</p>\n";
  return out;
}

std::string verdict_section(const Summary& s) {
  if (s.verdicts.empty()) return {};
  std::string out =
      "<h2>Expectations</h2>\n<div class=scroll><table><tr><th>of<th class=left>what"
      "<th class=left>verdict<th>measured<th>expected</tr>\n";
  for (const auto& v : s.verdicts) {
    out += fmt::format("<tr><td>{}<td class=left>{}<td class='left {}'>{}<td>{}<td>{}</tr>\n",
                       report::html::escaped(v.subject), report::html::escaped(v.what),
                       v.passed ? "ok" : "bad", v.passed ? "pass" : "fail",
                       report::html::escaped(v.measured), report::html::escaped(v.expected));
  }
  return out + "</table></div>\n";
}

std::vector<double> difference(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> out(a.size());
  std::transform(a.begin(), a.end(), b.begin(), out.begin(), std::minus<>{});
  return out;
}

double largest(const std::vector<double>& v) {
  double most = 0;
  for (const double x : v) most = std::max(most, std::abs(x));
  return most;
}

std::vector<double> scaled(std::vector<double> v, double by) {
  for (double& x : v) x *= by;
  return v;
}

std::string axis_figures(const char* axis, const AttitudeTrace& t,
                         const std::vector<double>& estimate, const std::vector<double>& truth,
                         const std::vector<double>& sigma) {
  report::Figure level{fmt::format("{}: truth and estimate", axis), "time [s]", "deg", {}};
  if (!truth.empty()) level.curves.push_back({"truth", t.t_s, truth});
  level.curves.push_back({"estimate", t.t_s, estimate});
  std::string out = report::html::figure(level);
  if (truth.empty()) return out;
  report::Figure error{
      fmt::format("{}: error with the filter's 3-sigma band", axis), "time [s]", "deg", {}};
  // The band begins tens of degrees wide, so the error sets the limit of the axis.
  error.y_limit = 1.3 * largest(difference(estimate, truth));
  error.curves.push_back({"3 sigma", t.t_s, scaled(sigma, 3), true});
  error.curves.push_back({"estimate - truth", t.t_s, difference(estimate, truth)});
  return out + report::html::figure(error);
}

std::string program_section(const EstimatorSummary& e) {
  if (!e.program) return {};
  return fmt::format("<p>Another program{}. {}</p>\n", program_text(*e.program),
                     report::html::escaped(e.program->failure));
}

std::string estimator_section(const Summary& s, std::size_t i) {
  const auto& e = s.estimators[i];
  std::string out =
      fmt::format("<h2>Estimator {} <span class=soft>({})</span></h2>\n{}",
                  report::html::escaped(e.name), report::html::escaped(e.kind), error_table(e)) +
      integrity_table(e) + program_section(e) + navigation_section(e.navigation, s.navigation[i]);
  const auto& t = s.traces[i];
  if (t.t_s.empty()) return out;
  out += axis_figures("Roll", t, t.roll_deg, t.true_roll_deg, t.roll_sigma_deg);
  return out + axis_figures("Pitch", t, t.pitch_deg, t.true_pitch_deg, t.pitch_sigma_deg);
}

std::string measurement_section(const Summary& s) {
  std::string out = "<h2>Measurements, decoded from the wire</h2>\n";
  for (const auto& m : s.measurements) {
    const report::Figure plot = figure_of(m, s.findings, s.duration_s);
    if (!plot.curves.empty()) out += report::html::figure(plot);
  }
  return out;
}

report::Figure track_figure(const Summary& s) {
  report::Figure track{
      "Track", "east [m]", "north [m]", {{"truth", s.motion.east_m, s.motion.north_m}}};
  track.equal_scales = true;
  if (s.loop && !s.loop->waypoints.empty()) {
    report::Curve waypoints{"waypoints", {}, {}, false, true};
    for (const auto& waypoint : s.loop->waypoints) {
      waypoints.x.push_back(waypoint.east_m);
      waypoints.y.push_back(waypoint.north_m);
    }
    track.curves.push_back(std::move(waypoints));
  }
  return track;
}

report::Figure depth_figure(const Summary& s) {
  report::Figure depth{
      "Depth", "time [s]", "m below the surface", {{"truth", s.motion.t_s, s.motion.depth_m}}};
  depth.y_down = true;
  return depth;
}

std::string motion_section(const Summary& s) {
  if (s.motion.t_s.empty()) return {};
  return "<h2>The emulated vehicle</h2>\n" + report::html::figure(track_figure(s)) +
         report::html::figure(depth_figure(s));
}

std::string process_section(const Summary& s) {
  if (s.resident.t_s.size() < 2) return {};
  return "<h2>This process</h2>\n" +
         report::html::figure({"Resident memory",
                               "time [s]",
                               "MB",
                               {{"resident", s.resident.t_s, s.resident.megabytes}}});
}

}  // namespace

std::string to_html(const Summary& s) {
  const std::size_t streaming = static_cast<std::size_t>(std::count_if(
      s.devices.begin(), s.devices.end(), [](const auto& d) { return d.state == "streaming"; }));
  std::string out = fmt::format(
      "<p class=soft>{}, {:.1f} s of bench time in {:.1f} s, seed {}{}</p>\n"
      "<p><span class={}>{} of {} devices streaming</span> at the end.</p>\n",
      report::html::escaped(s.mode), s.duration_s, s.wall_s, s.seed,
      s.interrupted ? ", interrupted" : "", streaming == s.devices.size() ? "ok" : "bad", streaming,
      s.devices.size());
  for (const auto& note : s.notes) out += fmt::format("<p>{}</p>\n", report::html::escaped(note));
  if (s.loop) out += loop_section(*s.loop);
  out += verdict_section(s) + finding_section(s) + fault_section(s) + "<h2>Health</h2>\n" +
         health_table(s);
  for (std::size_t i = 0; i < s.estimators.size(); ++i) out += estimator_section(s, i);
  out += measurement_section(s) + motion_section(s) + process_section(s);
  return report::html::page(s.rig, out);
}

}  // namespace drydock::summary
