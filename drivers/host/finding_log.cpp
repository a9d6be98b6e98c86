#include "drivers/host/finding_log.hpp"

#include <algorithm>

namespace drydock::host {

void FindingLog::on_finding(const diagnosis::Finding& finding) {
  if (auto* known = last_open(finding.device, finding.cause)) {
    *known = finding;
  } else if (all_.size() < most) {
    all_.push_back(finding);
  } else if (!finding.until) {
    ++not_kept_;
  }
}

void FindingLog::on_clock_step(std::chrono::nanoseconds step) {
  stepped_ += step;
  for (auto& finding : all_) {
    finding.since += step;
    finding.found += step;
    if (finding.until) *finding.until += step;
  }
}

const diagnosis::Finding* FindingLog::open(std::uint16_t device) const {
  const auto found = std::find_if(all_.rbegin(), all_.rend(), [&](const auto& one) {
    return one.device == device && !one.until;
  });
  return found == all_.rend() ? nullptr : &*found;
}

diagnosis::Finding* FindingLog::last_open(std::uint16_t device, diagnosis::Cause cause) {
  const auto found = std::find_if(all_.rbegin(), all_.rend(), [&](const auto& one) {
    return one.device == device && one.cause == cause && !one.until;
  });
  return found == all_.rend() ? nullptr : &*found;
}

}  // namespace drydock::host
