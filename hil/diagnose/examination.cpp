#include "hil/diagnose/examination.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "drivers/diagnosis/judge.hpp"
#include "drivers/host/finding_lines.hpp"
#include "drivers/host/rig_bus.hpp"
#include "hil/summary/findings.hpp"

namespace drydock::diagnose {

namespace {

/// A repeated message is seen by its own time; all other signs of duplicates count frames in time.
bool is_counted_in_time(const diagnosis::FindingAccount& finding) {
  return finding.cause == "duplicate" &&
         std::ranges::none_of(finding.evidence, [](const diagnosis::EvidenceAccount& one) {
           return one.quantity == "log-likelihood of repeated messages";
         });
}

/// Such a finding means nothing where the times are made up; the outcome names its cause as unseen.
bool is_of_times(const diagnosis::FindingAccount& finding) {
  if (is_counted_in_time(finding)) return true;
  const auto facts =
      std::ranges::find(diagnosis::causes(), finding.cause, &diagnosis::CauseFacts::name);
  return facts != diagnosis::causes().end() && needs_times(facts->cause);
}

}  // namespace

Examination::Examination(const rig_config::Rig& rig, measurement::Stamp start, double expected_s)
    : rig_(rig), start_(start), scribe_(rig, nullptr, start, expected_s), stalls_(start) {}

void Examination::Stalls::on_stall(Stamp from, Stamp to) {
  notes.push_back(fmt::format("at {:.1f} s {}", measurement::seconds(from - start),
                              host::stall_line(measurement::seconds(to - from))));
}

void Examination::follow(host::Followers& followers, std::vector<const device::Device*> devices) {
  devices_ = std::move(devices);
  diagnostician_.emplace(rig_, followers);
  diagnostician_->watch(devices_);
  followers.add(*diagnostician_);
  followers.add(findings_);
  followers.add(scribe_);
  followers.add(head_depths_);
  followers.add(stalls_);
  followers.add(late_wakes_);
}

Outcome Examination::result(const std::string& source, measurement::Stamp end, bool live,
                            bool has_times, bool rates_stated) const {
  Outcome outcome;
  outcome.source = source;
  outcome.notes = stalls_.notes;
  if (auto note = late_wakes_.note(); !note.empty()) outcome.notes.push_back(std::move(note));
  outcome.circumstances = {measurement::seconds(end - start_ - findings_.stepped()), live,
                           has_times, rates_stated};
  for (const auto device : head_depths_.changed)
    outcome.circumstances.heads_with_depth.push_back(rig_.devices.at(device).name);
  for (const auto* device : devices_)
    outcome.devices.push_back(device::account_of(*device, device->health(end),
                                                 host::provenance_of(device->options().link)));
  summary::Summary curves;
  scribe_.write(curves);
  outcome.measurements = std::move(curves.measurements);
  host::FindingLog findings = findings_;  // those that last have grown since they began
  for (const auto* device : devices_)
    if (const auto* open = diagnostician_->judge().open(device->index()))
      findings.on_finding(*open);
  outcome.findings = summary::accounts_of(findings, rig_, start_);
  if (!has_times) std::erase_if(outcome.findings, is_of_times);
  put_worst_first(outcome.findings);
  outcome.unseen = unseen_in(rig_, outcome.circumstances);
  const auto hidden = hidden_from_start(rig_, outcome.circumstances);
  outcome.unseen.insert(outcome.unseen.end(), hidden.begin(), hidden.end());
  return outcome;
}

}  // namespace drydock::diagnose
