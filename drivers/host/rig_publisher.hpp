#pragma once

#include <algorithm>
#include <vector>

#include "drivers/bus/publisher.hpp"
#include "drivers/host/finding_status.hpp"
#include "drivers/host/follower.hpp"
#include "drivers/host/integrity_status.hpp"
#include "drivers/host/told_status.hpp"

namespace drydock::host {

/// Puts measurements, estimates with their integrity, health, findings and the settings of emulated
/// devices of a run on the bus. The truth is not among them: bench::BusTruth.
class RigPublisher final : public Follower {
 public:
  RigPublisher(const bus::Participant& participant, const std::vector<bus::Device>& devices,
               const std::vector<std::string>& estimators = {},
               const std::vector<std::string>& navigators = {})
      : to_(participant, devices, estimators, navigators),
        findings_(devices),
        integrity_(estimators) {}

  void on_measurement(const measurement::Measurement& m) override {
    to_.publish(m);
    look(measurement::origin_of(m).received_at);
  }
  void on_estimate(const Estimate& estimate) override {
    to_.publish(estimate.attitude, estimate.estimator);
    if (estimate.navigation) to_.publish(*estimate.navigation, estimate.estimator);
    if (const auto status = integrity_.take(estimate))
      to_.publish({&*status, 1}, estimate.attitude.valid_at);
  }
  void on_health(const HealthReport& health, Stamp now) override {
    to_.publish(health.statuses(), now);
    if (!findings_.open().empty()) to_.publish(findings_.open(), now);
    if (!told_.empty()) to_.publish(told_, now);
    look(now);
  }
  void on_finding(const diagnosis::Finding& finding) override {
    const auto status = findings_.take(finding);
    to_.publish({&status, 1}, finding.until.value_or(finding.found));
  }

  /// What hosts have told an emulated device: at once, and with the health again.
  void tell(const Told& told, Stamp now) {
    const auto status = status_of(told);
    const auto known = std::ranges::find(told_, status.name, &bus::DeviceStatus::name);
    if (known == told_.end())
      told_.push_back(status);
    else
      *known = status;
    to_.publish({&status, 1}, now);
  }

  /// Says which estimates are too old by now.
  void look(Stamp now) {
    integrity_.look(now, [&](const bus::DeviceStatus& status) { to_.publish({&status, 1}, now); });
  }

 private:
  bus::Publisher to_;
  FindingStatuses findings_;
  IntegrityStatuses integrity_;
  std::vector<bus::DeviceStatus> told_;
};

}  // namespace drydock::host
