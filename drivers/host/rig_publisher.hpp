#pragma once

#include "drivers/bus/publisher.hpp"
#include "drivers/host/finding_status.hpp"
#include "drivers/host/follower.hpp"
#include "drivers/host/integrity_status.hpp"

namespace drydock::host {

/// Puts measurements, estimates with their integrity, health and findings of a run on the bus. The
/// truth is not among them: bench::BusTruth.
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
    look(now);
  }
  void on_finding(const diagnosis::Finding& finding) override {
    const auto status = findings_.take(finding);
    to_.publish({&status, 1}, finding.until.value_or(finding.found));
  }

  /// Says which estimates are too old by now.
  void look(Stamp now) {
    integrity_.look(now, [&](const bus::DeviceStatus& status) { to_.publish({&status, 1}, now); });
  }

 private:
  bus::Publisher to_;
  FindingStatuses findings_;
  IntegrityStatuses integrity_;
};

}  // namespace drydock::host
