#include "hil/diagnose/outcome.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <tuple>

#include "drivers/diagnosis/finding_words.hpp"
#include "drivers/text/json_of_any_text.hpp"
#include "hil/report/html.hpp"
#include "hil/summary/findings.hpp"
#include "hil/summary/findings_json.hpp"

namespace drydock::diagnose {
namespace {

using diagnosis::FindingAccount;
using report::html::escaped;

std::string in_a_row(const std::vector<std::string>& names) {
  std::string row;
  for (const auto& name : names) row.append(row.empty() ? "" : ", ").append(name);
  return row;
}

std::string names_of(const std::vector<diagnosis::Cause>& causes) {
  std::string names;
  for (const auto cause : causes)
    names.append(names.empty() ? "" : ", ").append(diagnosis::facts_of(cause).name);
  return names;
}

std::string header(const Outcome& outcome) {
  const auto heard = std::ranges::count_if(outcome.devices,
                                           [](const auto& device) { return device.messages > 0; });
  return fmt::format("{}: {:.1f} s, {} of {} devices heard\n", outcome.source,
                     outcome.circumstances.duration_s, heard, outcome.devices.size());
}

/// What the driver said last about an error, as "  it says: ..."; empty: nothing.
std::string driver_says(const std::string& device, const Outcome& outcome) {
  const auto own = std::ranges::find(outcome.devices, device, &summary::DeviceSummary::name);
  const bool said = own != outcome.devices.end() && !own->last_error.empty();
  return said ? "  its driver says: " + own->last_error + '\n' : std::string();
}

std::string finding_text(const FindingAccount& finding, const Outcome& outcome) {
  return fmt::format("{}: {} {}, {:.0f} % sure: {}\n  because: {}\n{}  try: {}\n", finding.device,
                     finding.cause, diagnosis::when_text(finding), 100 * finding.confidence,
                     finding.meaning, diagnosis::evidence_text(finding),
                     driver_says(finding.device, outcome), finding.advice);
}

/// Empty: nothing on the wire tells why the device is silent.
std::string hint_of(const std::string& device, const Outcome& outcome) {
  const auto hint = outcome.hints.find(device);
  return hint == outcome.hints.end() ? std::string() : hint->second;
}

std::string unheard_text(const Outcome& outcome) {
  std::string out;
  for (const auto& device : outcome.devices) {
    if (device.messages > 0) continue;
    const auto hint = hint_of(device.name, outcome);
    out += fmt::format("{}: no measurement came in {:.1f} s{}{}\n", device.name,
                       outcome.circumstances.duration_s, hint.empty() ? "" : ": ", hint);
  }
  return out;
}

bool all_heard(const Outcome& outcome) {
  return std::ranges::all_of(outcome.devices,
                             [](const auto& device) { return device.messages > 0; });
}

std::string found_line(const Outcome& outcome) {
  if (outcome.devices.empty())
    return "no sensor was recognised, so nothing could be diagnosed; `drydock probe` says more\n";
  if (outcome.findings.empty())
    return fmt::format("nothing found{} in {:.1f} s\n",
                       all_heard(outcome) ? "" : " on the devices that were heard",
                       outcome.circumstances.duration_s);
  const auto count = outcome.findings.size();
  return fmt::format("{} finding{}, the worst first\n", count, count == 1 ? "" : "s");
}

std::string unseen_text(const std::vector<Unseen>& unseen) {
  if (unseen.empty()) return {};
  std::string out = "these faults could not have been seen here:\n";
  for (const Unseen& one : unseen)
    out += fmt::format("  {}: {}: {}\n", in_a_row(one.devices), one.why, names_of(one.causes));
  return out;
}

nlohmann::ordered_json unseen_json(const std::vector<Unseen>& unseen) {
  auto all = nlohmann::ordered_json::array();
  for (const Unseen& one : unseen) {
    auto causes = nlohmann::ordered_json::array();
    for (const auto cause : one.causes)
      causes.push_back(std::string(diagnosis::facts_of(cause).name));
    all.push_back({{"devices", one.devices}, {"causes", causes}, {"why", one.why}});
  }
  return all;
}

/// The measurements of the device, with a shade for the time of this finding.
std::string plots_of(const FindingAccount& finding, const Outcome& outcome) {
  std::string out;
  for (const auto& trace : outcome.measurements) {
    if (trace.device != finding.device) continue;
    const auto figure = summary::figure_of(trace, {&finding, 1}, outcome.circumstances.duration_s);
    if (!figure.curves.empty()) out += report::html::figure(figure);
  }
  return out.empty() ? "<p class=soft>It gave no measurements.</p>\n" : out;
}

std::string finding_html(const FindingAccount& finding, const Outcome& outcome) {
  return fmt::format(
             "<h2>{}: <span class=bad>{}</span> {}</h2>\n<p>{}. {:.0f} % sure.</p>\n"
             "<p>Because: {}</p>\n<p>{}</p>\n<p>Try: {}</p>\n",
             escaped(finding.device), finding.cause, diagnosis::when_text(finding),
             escaped(finding.meaning), 100 * finding.confidence,
             escaped(diagnosis::evidence_text(finding)),
             escaped(driver_says(finding.device, outcome)), escaped(finding.advice)) +
         plots_of(finding, outcome);
}

std::string unseen_html(const std::vector<Unseen>& unseen) {
  if (unseen.empty()) return {};
  std::string out = "<h2>What could not have been seen here</h2>\n<ul>\n";
  for (const Unseen& one : unseen)
    out += fmt::format("<li>{}: {}: {}\n", escaped(in_a_row(one.devices)), escaped(one.why),
                       names_of(one.causes));
  return out + "</ul>\n";
}

}  // namespace

void put_worst_first(std::vector<FindingAccount>& findings) {
  std::ranges::stable_sort(findings, {}, [](const FindingAccount& one) {
    return std::tuple(!one.severe, one.until_s.has_value(), -one.confidence, one.since_s);
  });
}

std::string to_text(const Outcome& outcome) {
  std::string out = header(outcome);
  for (const auto& note : outcome.notes) out += note + '\n';
  out += found_line(outcome);
  for (const auto& finding : outcome.findings) out += finding_text(finding, outcome);
  return out + unheard_text(outcome) + unseen_text(outcome.unseen);
}

std::string to_json(const Outcome& outcome) {
  auto devices = nlohmann::ordered_json::array();
  for (const auto& device : outcome.devices)
    devices.push_back({{"name", device.name},
                       {"kind", device.kind},
                       {"protocol", device.protocol},
                       {"state", device.state},
                       {"rate_hz", device.rate_hz},
                       {"messages", device.messages},
                       {"hint", hint_of(device.name, outcome)}});
  const nlohmann::ordered_json json{{"source", outcome.source},
                                    {"duration_s", outcome.circumstances.duration_s},
                                    {"notes", outcome.notes},
                                    {"devices", devices},
                                    {"findings", summary::findings_json(outcome.findings)},
                                    {"unseen", unseen_json(outcome.unseen)}};
  return text::json_of_any_text(json) + "\n";
}

std::string to_html(const Outcome& outcome) {
  std::string body = "<p class=soft>" + escaped(header(outcome)) + "</p>\n";
  for (const auto& note : outcome.notes) body += "<p>" + escaped(note) + "</p>\n";
  body += "<p>" + found_line(outcome) + "</p>\n<p>" + escaped(unheard_text(outcome)) + "</p>\n";
  for (const auto& finding : outcome.findings) body += finding_html(finding, outcome);
  return report::html::page("Diagnosis of " + outcome.source, body + unseen_html(outcome.unseen));
}

}  // namespace drydock::diagnose
