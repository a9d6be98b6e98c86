#pragma once

#include "drivers/host/follower.hpp"
#include "estimators/pipeline/pipeline.hpp"
#include "rig_config/rig.hpp"

namespace drydock::host {

/// Estimators use sound devices only: while a finding says that a device's values mislead, they are
/// left out. An IMU stays in, because without it there is no estimate, but the estimates are not
/// valid (docs/estimators/integrity.md).
class SoundDevices final : public Follower {
 public:
  /// Rig and pipeline must outlive it.
  SoundDevices(const rig_config::Rig& rig, pipeline::Pipeline& pipeline)
      : rig_(rig), pipeline_(pipeline) {}

  void on_finding(const diagnosis::Finding& finding) override {
    const auto& facts = diagnosis::facts_of(finding.cause);
    const auto kind = rig_.devices.at(finding.device).kind;
    // Values are right at another time: the vehicle has turned and moved meanwhile.
    const bool mistimed =
        facts.mistimes && (kind == measurement::Kind::gnss || kind == measurement::Kind::attitude);
    if (!facts.misleads && !mistimed) return;
    if (kind == measurement::Kind::imu || mistimed)
      return pipeline_.doubt(finding.device, !finding.until);
    pipeline_.leave_out(finding.device, !finding.until, finding.until.value_or(finding.found));
  }

 private:
  const rig_config::Rig& rig_;
  pipeline::Pipeline& pipeline_;
};

}  // namespace drydock::host
