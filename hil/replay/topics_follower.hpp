#pragma once

#include "drivers/bus/cdr/cdr_publisher.hpp"
#include "drivers/host/follower.hpp"
#include "drivers/host/rig_bus.hpp"

namespace drydock::replay {

/// Passes the messages of a rig's run to a sink, without the truth.
class TopicsFollower final : public host::Follower {
 public:
  /// The sink must outlive the follower.
  TopicsFollower(bus::CdrSink& sink, const rig_config::Rig& rig)
      : topics_(sink, host::bus_devices(rig), host::estimator_names(rig),
                host::navigator_names(rig)) {}

  void on_measurement(const measurement::Measurement& m) override { topics_.publish(m); }
  void on_estimate(const host::Estimate& estimate) override {
    topics_.publish(estimate.attitude, estimate.estimator);
    if (estimate.navigation) topics_.publish(*estimate.navigation, estimate.estimator);
  }
  void on_health(const host::HealthReport& health, Stamp now) override {
    topics_.publish(health.statuses(), now);
  }

 private:
  bus::CdrPublisher topics_;
};

}  // namespace drydock::replay
