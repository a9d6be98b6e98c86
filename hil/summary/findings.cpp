#include "hil/summary/findings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "drivers/diagnosis/finding_words.hpp"
#include "hil/report/html.hpp"

namespace drydock::summary {

using diagnosis::FindingAccount;

std::vector<FindingAccount> accounts_of(const host::FindingLog& log, const rig_config::Rig& rig,
                                        measurement::Stamp start) {
  std::vector<FindingAccount> accounts;
  for (const auto& finding : log.all())
    accounts.push_back(
        diagnosis::account_of(finding, rig.devices.at(finding.device).name, start + log.stepped()));
  return accounts;
}

bool counts(const FindingAccount& finding, const std::string& device, double from_s) {
  return (device.empty() || finding.device == device) && finding.until_s.value_or(from_s) >= from_s;
}

std::string findings_text(std::span<const FindingAccount> findings) {
  constexpr std::size_t most_lines = 20;
  if (findings.empty()) return "no findings\n";
  std::string out;
  for (const auto& finding : findings.first(std::min(findings.size(), most_lines)))
    out += "finding " + diagnosis::line_of(finding) + '\n';
  if (findings.size() > most_lines)
    out += fmt::format("and {} findings more (--json has all)\n", findings.size() - most_lines);
  return out;
}

std::string findings_list(std::span<const FindingAccount> findings) {
  using report::html::escaped;
  if (findings.empty()) return "<p>No findings.</p>\n";
  std::string out = "<ul>\n";
  for (const auto& f : findings)
    out += fmt::format(
        "<li>{}: <span class=bad>{}</span> {}, {:.0f} % sure: {}. Because: {}. Try: {}\n",
        escaped(f.device), f.cause, diagnosis::when_text(f), 100 * f.confidence, escaped(f.meaning),
        escaped(diagnosis::evidence_text(f)), escaped(f.advice));
  return out + "</ul>\n";
}

report::Figure figure_of(const MeasurementTrace& trace, std::span<const FindingAccount> findings,
                         double end_s) {
  report::Figure figure{trace.title, "time [s]", trace.unit, {}};
  figure.y_down = trace.title.ends_with(": depth");
  for (std::size_t i = 0; i < trace.labels.size(); ++i)
    if (!trace.t_s[i].empty())
      figure.curves.push_back({trace.labels[i], trace.t_s[i], trace.value[i]});
  for (const auto& finding : findings)
    if (finding.device == trace.device)
      figure.shades.push_back({finding.since_s, finding.until_s.value_or(end_s)});
  return figure;
}

}  // namespace drydock::summary
