#include "hil/summary/expect_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "hil/summary/findings.hpp"

namespace drydock::summary {
namespace {

/// A shorter one has nothing to judge: a run that ends at after_s ends a moment behind it.
constexpr double least_window_s = 0.01;

template <class Named>
std::size_t index_of(const std::vector<Named>& all, const std::string& name) {
  return static_cast<std::size_t>(std::ranges::find(all, name, &Named::name) - all.begin());
}

/// The device's counts since `before`. State and rate are the present ones.
DeviceSummary counted_since(const DeviceSummary& before, DeviceSummary now) {
  now.bytes_in -= before.bytes_in;
  now.bytes_good -= before.bytes_good;
  now.bytes_skipped -= before.bytes_skipped;
  now.frames -= before.frames;
  now.bad_checksums -= before.bad_checksums;
  now.messages -= before.messages;
  now.reopens -= before.reopens;
  return now;
}

std::vector<diagnosis::FindingAccount> findings_in(const rig_config::ExpectConfig& expect,
                                                   const Summary& summary) {
  std::vector<diagnosis::FindingAccount> found;
  std::ranges::copy_if(summary.findings, std::back_inserter(found), [&](const auto& finding) {
    return counts(finding, expect.device, expect.after_s);
  });
  return found;
}

}  // namespace

ExpectWatch::ExpectWatch(const rig_config::Rig& rig, const motion::Trajectory* truth,
                         measurement::Stamp start, std::function<Counts(measurement::Stamp)> counts)
    : rig_(rig), truth_(truth), start_(start), counts_(std::move(counts)) {
  windows_.resize(rig.expects.size());
  for (std::size_t i = 0; i < windows_.size(); ++i) windows_[i].expect = &rig.expects[i];
}

void ExpectWatch::on_state(const device::Device& device, const device::Transition& change) {
  const double t = measurement::seconds(steady(change.at) - start_);
  for (Window& w : windows_) {
    const auto& e = *w.expect;
    if (e.device != device.name() || e.state.empty() || !(e.after_s > 0) || t <= e.after_s)
      continue;
    // From after_s until the first change, the device was in the state `from`.
    for (const auto& [state, since] :
         {std::pair{to_string(change.from), e.after_s}, std::pair{to_string(change.to), t}}) {
      if (w.other_state.empty() && state != e.state)
        w.other_state = fmt::format("{} at {:.1f} s", state, since);
    }
  }
}

bool ExpectWatch::concerns(const Window& w, std::size_t estimator, measurement::Stamp at) const {
  return w.expect->after_s > 0 && w.expect->estimator == rig_.estimators[estimator].name &&
         measurement::seconds(at - start_) >= w.expect->after_s;
}

void ExpectWatch::on_estimate(const host::Estimate& estimate) {
  const auto at = steady(estimate.attitude.valid_at);
  for (Window& w : windows_) {
    if (!concerns(w, estimate.estimator, at)) continue;
    ++w.estimates;
    w.rate.add(at);
    if (!truth_) continue;
    const auto truth = truth_->at(at);
    w.attitude.add(estimate.attitude, truth, measurement::seconds(at - start_));
    if (estimate.navigation)
      w.navigation.note(*estimate.navigation, estimate.current, &truth, 0, false);
  }
}

void ExpectWatch::tick(measurement::Stamp now) {
  const double t = measurement::seconds(now - start_);
  std::optional<Counts> counts;
  for (Window& w : windows_) {
    if (w.begun || !(w.expect->after_s > 0) || t < w.expect->after_s) continue;
    w.begun = true;
    w.begun_s = t;
    if (!absent_from_rig(*w.expect).empty()) continue;
    if (!counts) counts = counts_(now);
    if (!w.expect->estimator.empty()) {
      w.estimator_before = counts->estimators[index_of(rig_.estimators, w.expect->estimator)];
    } else if (!w.expect->device.empty()) {
      w.device_before = counts->devices[index_of(rig_.devices, w.expect->device)];
    }
  }
}

/// A recording whose files are not whole is played without its estimators.
std::string ExpectWatch::absent_from_rig(const rig_config::ExpectConfig& expect) const {
  if (index_of(rig_.estimators, expect.estimator) == rig_.estimators.size() &&
      !expect.estimator.empty())
    return "this estimator does not run";
  if (index_of(rig_.devices, expect.device) == rig_.devices.size() && !expect.device.empty())
    return "this device does not run";
  return {};
}

Outcome ExpectWatch::of_device(const Window& w, const Summary& summary) const {
  Outcome found;
  found.device =
      counted_since(w.device_before, summary.devices[index_of(rig_.devices, w.expect->device)]);
  found.other_state = w.other_state;
  return found;
}

Outcome ExpectWatch::of_estimator(const Window& w, const Summary& summary,
                                  const std::vector<pipeline::EstimatorStatus>& at_end) const {
  const std::size_t i = index_of(rig_.estimators, w.expect->estimator);
  EstimatorSummary seen = summary.estimators[i];
  if (w.begun) {
    const auto& now = at_end[i];
    seen.estimates = w.estimates;
    seen.rejected = now.rejected - w.estimator_before.rejected;
    seen.valid_share = pipeline::valid_share(w.estimator_before, now);
    seen.nis = (now.taken - w.estimator_before.taken).mean();
    seen.rate_hz = w.rate.hz();
    seen.whole_run.reset();
    if (w.attitude.count() > 0) seen.whole_run = w.attitude.result();
    seen.navigation = w.navigation.error();
  }
  Outcome found;
  found.estimator = std::move(seen);
  return found;
}

void ExpectWatch::write(Summary& summary,
                        const std::vector<pipeline::EstimatorStatus>& at_end) const {
  for (std::size_t i = 0; i < summary.estimators.size(); ++i) {
    summary.estimators[i].rejected = at_end[i].rejected;
    summary.estimators[i].valid_share = pipeline::valid_share({}, at_end[i]);
    summary.estimators[i].nis = at_end[i].taken.mean();
  }
  for (const Window& w : windows_) {
    Outcome found;
    found.absent = absent_from_rig(*w.expect);
    const bool came =
        found.absent.empty() &&
        (!(w.expect->after_s > 0) || (w.begun && summary.duration_s - w.begun_s >= least_window_s));
    if (came && !w.expect->estimator.empty()) found = of_estimator(w, summary, at_end);
    if (came && !w.expect->device.empty()) found = of_device(w, summary);
    if (came) found.findings = findings_in(*w.expect, summary);
    found.duration_s = summary.duration_s;
    std::ranges::move(judge(*w.expect, found), std::back_inserter(summary.verdicts));
  }
}

}  // namespace drydock::summary
