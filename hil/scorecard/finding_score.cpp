#include "hil/scorecard/finding_score.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "drivers/diagnosis/surroundings.hpp"

namespace drydock::scorecard {
namespace {

using diagnosis::Cause;

/// The monitors that look at counters of the last moment may speak a little after the fault.
constexpr double grace_s = 2;

/// A fault of the bus harms all devices on it.
bool is_harmed(const rig_config::Rig& rig, const rig_config::FaultConfig& fault,
               std::size_t device) {
  using Need = rig_config::FaultNeed;
  const auto& harmed = rig.devices[device];
  if (harmed.name == fault.device) return true;
  const auto& facts = rig_config::word_of(fault.kind).facts;
  const auto has_fault = [&](const auto& one) {
    return one.name == fault.device && one.link == harmed.link;
  };
  return facts.needs == Need::can_bus && std::ranges::any_of(rig.devices, has_fault);
}

bool looks_like(Cause cause, rig_config::FaultKind fault) {
  return std::ranges::count(diagnosis::facts_of(cause).faults, fault) > 0;
}

double seconds_within(const FindingAt& finding, const Window& window) {
  const double from = std::max(finding.found_s, window.warm_up_s);
  const double to =
      std::min(finding.until_s.value_or(window.run_s()), window.fault_end_s() + grace_s);
  return std::max(to - from, 0.0);
}

/// The fault of this pair, and the one beside it, harm these.
bool is_harmed(const rig_config::Rig& rig, const Pair& pair, std::size_t device) {
  return is_harmed(rig, pair.fault, device) || (pair.also && is_harmed(rig, *pair.also, device));
}

bool overlap(const FindingAt& one, const FindingAt& other) {
  constexpr double never_over_s = std::numeric_limits<double>::infinity();
  return one.found_s <= other.until_s.value_or(never_over_s) &&
         other.found_s <= one.until_s.value_or(never_over_s);
}

/// Bed and sky are as they are in the run without faults.
std::vector<FindingAt> less_surroundings(std::vector<FindingAt> findings,
                                         const std::vector<FindingAt>& sound) {
  std::erase_if(findings, [&](const FindingAt& finding) {
    return diagnosis::is_of_the_surroundings(finding.cause) &&
           std::ranges::any_of(sound, [&](const FindingAt& one) {
             return one.device == finding.device && one.cause == finding.cause &&
                    overlap(one, finding);
           });
  });
  return findings;
}

std::vector<std::string> others_accused(const rig_config::Rig& rig, const Window& window,
                                        const Pair& pair, const std::vector<FindingAt>& findings) {
  std::set<std::pair<std::size_t, Cause>> accused;
  for (const FindingAt& finding : findings)
    if (finding.found_s >= window.warm_up_s && !is_harmed(rig, pair, finding.device))
      accused.emplace(finding.device, finding.cause);
  std::vector<std::string> names;
  names.reserve(accused.size());
  for (const auto& [device, cause] : accused)
    names.push_back(rig.devices[device].name + " " + std::string(diagnosis::facts_of(cause).name));
  return names;
}

}  // namespace

FindingScore judge_findings(const rig_config::Rig& rig, const Window& window, const Pair& pair,
                            const std::vector<FindingAt>& sound, const RunRecord& run) {
  FindingScore score;
  const auto findings = less_surroundings(run.findings, sound);
  score.others = others_accused(rig, window, pair, findings);
  std::map<Cause, double> said_s;
  const FindingAt* first = nullptr;
  for (const FindingAt& finding : findings) {
    if (finding.found_s < window.warm_up_s) ++score.before;
    const double within_s = seconds_within(finding, window);
    if (finding.found_s < window.warm_up_s || within_s <= 0) continue;
    if (pair.also && is_harmed(rig, *pair.also, finding.device)) continue;
    if (first == nullptr) first = &finding;
    if (is_harmed(rig, pair.fault, finding.device)) said_s[finding.cause] += within_s;
  }
  if (first == nullptr) return score;
  score.found_s = first->found_s - window.warm_up_s;
  score.right_device = is_harmed(rig, pair.fault, first->device);
  const auto longest = std::ranges::max_element(said_s, {}, [](const auto& x) { return x.second; });
  const Cause cause = longest == said_s.end() ? first->cause : longest->first;
  score.word = diagnosis::facts_of(cause).name;
  score.right_word = !said_s.empty() && looks_like(cause, pair.fault.kind);
  return score;
}

}  // namespace drydock::scorecard
