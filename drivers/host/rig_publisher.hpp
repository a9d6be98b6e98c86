#pragma once

#include "drivers/bus/publisher.hpp"
#include "drivers/host/follower.hpp"

namespace drydock::host {

/// Puts measurements, estimates and health of a run on the bus. The truth is not on the bus.
class RigPublisher final : public Follower {
 public:
  RigPublisher(const bus::Participant& participant, const std::vector<bus::Device>& devices,
               const std::vector<std::string>& estimators = {},
               const std::vector<std::string>& navigators = {})
      : to_(participant, devices, estimators, navigators) {}

  void on_measurement(const measurement::Measurement& m) override { to_.publish(m); }
  void on_estimate(const Estimate& estimate) override {
    to_.publish(estimate.attitude, estimate.estimator);
    if (estimate.navigation) to_.publish(*estimate.navigation, estimate.estimator);
  }
  void on_health(const HealthReport& health, Stamp now) override {
    to_.publish(health.statuses(), now);
  }

 private:
  bus::Publisher to_;
};

}  // namespace drydock::host
