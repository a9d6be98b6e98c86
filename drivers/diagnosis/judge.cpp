#include "drivers/diagnosis/judge.hpp"

#include <algorithm>

#include "drivers/diagnosis/verdict.hpp"

namespace drydock::diagnosis {
namespace {

/// A sign that was not seen for so long is over.
constexpr std::chrono::seconds memory{5};

/// Bad signs first told by one another: the evidence of a finding, earliest first.
void fill_evidence(Finding& finding, std::span<const Symptom> signs) {
  finding.evidence.clear();
  for (const Symptom& symptom : signs)
    if (finding.evidence.size() < finding.evidence.capacity())
      finding.evidence.push_back(
          {symptom.sign, symptom.value, symptom.limit, symptom.quantity, symptom.unit});
}

Stamp beginning_of(std::span<const Symptom> signs) {
  return std::ranges::min(signs, {}, &Symptom::since).since;
}

}  // namespace

Judge::Judge(std::size_t devices, FindingListener& to) : cases_(devices), to_(to) {}

void Judge::see(const Symptom& symptom) {
  auto& signs = cases_.at(symptom.device).signs;
  const auto known = std::ranges::find(signs, symptom.sign, &Symptom::sign);
  if (known != signs.end()) {
    const Stamp since = std::min(known->since, symptom.since);
    *known = symptom;
    known->since = since;
  } else if (signs.size() < signs.capacity()) {
    signs.push_back(symptom);
  }
}

void Judge::settle(Stamp now) {
  for (std::size_t device = 0; device < cases_.size(); ++device) {
    Case& one = cases_[device];
    forget_old(one, now);
    const auto verdict = verdict_on({one.signs.data(), one.signs.size()});
    if (one.finding && (!verdict || verdict->cause != one.finding->cause)) {
      one.finding->until = now;
      to_.on_finding(*one.finding);
      one.finding.reset();
    }
    if (!verdict || one.finding) continue;
    Finding& finding = one.finding.emplace();
    finding.device = static_cast<std::uint16_t>(device);
    finding.cause = verdict->cause;
    finding.confidence = verdict->confidence;
    finding.since = beginning_of({one.signs.data(), one.signs.size()});
    finding.found = now;
    fill_evidence(finding, {one.signs.data(), one.signs.size()});
    to_.on_finding(finding);
  }
}

void Judge::forget_old(Case& one, Stamp now) {
  auto& signs = one.signs;
  signs.erase(std::remove_if(signs.begin(), signs.end(),
                             [&](const Symptom& symptom) { return now - symptom.at > memory; }),
              signs.end());
}

const Finding* Judge::open(std::uint16_t device) const {
  const auto& finding = cases_.at(device).finding;
  return finding ? &*finding : nullptr;
}

}  // namespace drydock::diagnosis
