#include "drivers/diagnosis/judge.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace drydock::diagnosis {
namespace {

/// A sign that was not seen for so long is over. States are told at each look, events when they
/// happen: a fault that strikes one message in five comes at least so often.
std::chrono::milliseconds memory_of(Sign sign) {
  switch (sign) {
    case Sign::silent:
    case Sign::port_lost:
    case Sign::nothing_decodes:
    case Sign::prompts:
    case Sign::bus_off:
    case Sign::bus_taken:
    case Sign::address_taken:
    case Sign::late:
    case Sign::clock_step:
    case Sign::clock_drift:
    case Sign::heat:
    case Sign::refuses:
    case Sign::error_report:
    case Sign::rate_unexpected:
    case Sign::line_full:
    case Sign::step: return std::chrono::milliseconds{1500};
    case Sign::stuck:
    case Sign::out_of_range:
    case Sign::noisy:
    case Sign::values_missing:
    case Sign::rate_low:
    case Sign::rate_high: return std::chrono::seconds{3};
    default: return std::chrono::seconds{10};
  }
}

/// A sign that began so long after a finding was known is of another trouble.
constexpr std::chrono::seconds same_trouble{3};

void add_evidence(Finding& finding, const Symptom& symptom) {
  if (finding.evidence.size() == finding.evidence.capacity()) return;
  const double limit = symptom.value < 0 ? -std::abs(symptom.limit) : symptom.limit;
  finding.evidence.push_back({symptom.sign, symptom.value, limit, symptom.quantity, symptom.unit});
}

/// What decided comes first, then the others.
void fill_evidence(Finding& finding, std::span<const Symptom> signs, Sign decided) {
  finding.evidence.clear();
  for (const Symptom& symptom : signs)
    if (symptom.sign == decided) add_evidence(finding, symptom);
  for (const Symptom& symptom : signs)
    if (symptom.sign != decided) add_evidence(finding, symptom);
}

/// A silence grows while it lasts.
void renew_durations(Finding& finding, std::span<const Symptom> signs) {
  for (Evidence& one : finding.evidence) {
    if (one.sign != Sign::silent) continue;
    const auto seen = std::ranges::find(signs, one.sign, &Symptom::sign);
    if (seen != signs.end()) one.value = std::max(one.value, seen->value);
  }
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

/// Events that were last seen while another sign decided are part of what that sign told: they make
/// no finding of their own when it is over.
void Judge::forget_explained(Case& one) {
  if (!one.finding || find(one, one.decided_by) != one.signs.end()) return;
  const auto last = std::remove_if(one.signs.begin(), one.signs.end(), [&](const Symptom& symptom) {
    return symptom.at <= one.decided_at;
  });
  one.signs.erase(last, one.signs.end());
}

void Judge::settle(Stamp now) {
  for (std::size_t device = 0; device < cases_.size(); ++device) {
    Case& one = cases_[device];
    if (one.signs.empty() && !one.finding) continue;
    forget_old(one, now);
    forget_explained(one);
    const std::span<const Symptom> signs{one.signs.data(), one.signs.size()};
    const auto verdict = verdict_on(signs);
    if (one.finding && verdict && verdict->cause == one.finding->cause) {
      renew_durations(*one.finding, signs);
      note_decided(one, verdict->by);
      continue;
    }
    const auto before = end(one, now);
    if (verdict) begin(one, static_cast<std::uint16_t>(device), *verdict, before, now);
  }
}

void Judge::end_all(Stamp until) {
  for (Case& one : cases_) end(one, until);
}

std::optional<Finding> Judge::end(Case& one, Stamp now) {
  if (!one.finding) return {};
  one.finding->until = now;
  to_.on_finding(*one.finding);
  return std::exchange(one.finding, {});
}

void Judge::begin(Case& one, std::uint16_t device, const Verdict& verdict,
                  const std::optional<Finding>& before, Stamp now) {
  const std::span<const Symptom> signs{one.signs.data(), one.signs.size()};
  Finding& finding = one.finding.emplace();
  finding.device = device;
  finding.cause = verdict.cause;
  finding.confidence = verdict.confidence;
  const Symptom& decided = *find(one, verdict.by);
  finding.since = decided.since;
  // A better word is about the same trouble, unless that began when the first was long known.
  if (before && decided.since - before->found <= same_trouble)
    finding.since = std::min(before->since, decided.since);
  finding.found = now;
  finding.advice = decided.advice;
  note_decided(one, verdict.by);
  fill_evidence(finding, signs, verdict.by);
  to_.on_finding(finding);
}

Judge::Signs::const_iterator Judge::find(const Case& one, Sign sign) {
  return std::ranges::find(one.signs, sign, &Symptom::sign);
}

void Judge::note_decided(Case& one, Sign by) {
  one.decided_by = by;
  one.decided_at = find(one, by)->at;
}

void Judge::forget_old(Case& one, Stamp now) {
  auto& signs = one.signs;
  signs.erase(std::remove_if(signs.begin(), signs.end(),
                             [&](const Symptom& symptom) {
                               return now - symptom.at > memory_of(symptom.sign);
                             }),
              signs.end());
}

const Finding* Judge::open(std::uint16_t device) const {
  const auto& finding = cases_.at(device).finding;
  return finding ? &*finding : nullptr;
}

}  // namespace drydock::diagnosis
