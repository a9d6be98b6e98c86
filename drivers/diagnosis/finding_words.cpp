#include "drivers/diagnosis/finding_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

namespace drydock::diagnosis {

std::string in_words(const EvidenceAccount& evidence) {
  const char* bound = evidence.value < evidence.limit ? "at least" : "at most";
  if (evidence.unit.empty())
    return fmt::format("{:.4g} {} ({} {:.4g})", evidence.value, evidence.quantity, bound,
                       evidence.limit);
  return fmt::format("{0} {1:.4g} {4} ({2} {3:.4g} {4})", evidence.quantity, evidence.value, bound,
                     evidence.limit, evidence.unit);
}

std::string evidence_text(const FindingAccount& finding) {
  std::vector<std::string> said;  // two signs of one test have the same words
  for (const EvidenceAccount& one : finding.evidence)
    if (const auto words = in_words(one); std::ranges::find(said, words) == said.end())
      said.push_back(words);
  return fmt::format("{}", fmt::join(said, ", "));
}

std::string when_text(const FindingAccount& finding) {
  return finding.until_s
             ? fmt::format("from {:.1f} s to {:.1f} s", finding.since_s, *finding.until_s)
             : fmt::format("since {:.1f} s", finding.since_s);
}

std::string line_of(const FindingAccount& finding, const std::string& when) {
  const std::string evidence = evidence_text(finding);
  return fmt::format("{}: {} {}{}{} — {}", finding.device, finding.cause, when,
                     evidence.empty() ? "" : ": ", evidence, finding.advice);
}

std::string line_of(const FindingAccount& finding) { return line_of(finding, when_text(finding)); }

std::string end_line_of(const FindingAccount& finding) {
  return fmt::format("{}: no longer {} after {:.1f} s", finding.device, finding.cause,
                     finding.until_s.value_or(finding.found_s) - finding.since_s);
}

}  // namespace drydock::diagnosis
