#pragma once

#include "drivers/bus/publisher.hpp"
#include "drivers/host/follower.hpp"

namespace drydock::host {

/// Puts measurements, estimates and health of a run on the bus. The truth is not on the bus.
class RigPublisher final : public Follower {
 public:
  /// The publisher must outlive it.
  explicit RigPublisher(bus::Publisher& to) : to_(to) {}

  void on_measurement(const measurement::Measurement& m) override { to_.publish(m); }
  void on_estimate(const Estimate& estimate) override {
    to_.publish(estimate.attitude, estimate.estimator);
    if (estimate.navigation) to_.publish(*estimate.navigation, estimate.estimator);
  }
  void on_health(const HealthReport& health, Stamp now) override {
    to_.publish(health.statuses(), now);
  }

 private:
  bus::Publisher& to_;
};

}  // namespace drydock::host
