#pragma once

#include <optional>
#include <vector>

#include "drivers/host/follower.hpp"
#include "estimators/pipeline/listener.hpp"

namespace drydock::host {

/// Converts estimates to the types of the bus. `origin` is the first position of the same
/// estimator, from which the offset counts. What an estimate does not give is NaN there too.
Estimate bus_estimate(const pipeline::AttitudeEstimate& estimate);
Estimate bus_estimate(const pipeline::NavigationEstimate& estimate, const frame::Position& origin);
bus::Innovation bus_innovation(const pipeline::InnovationReport& report);

/// Tells a follower the estimates and innovations of a pipeline. It is the only place that converts
/// them.
class EstimateTeller final : public pipeline::EstimateListener {
 public:
  /// The follower must outlive the teller.
  explicit EstimateTeller(Follower& to) : to_(to) {}

  void on_attitude(const pipeline::AttitudeEstimate& estimate) override;
  void on_navigation(const pipeline::NavigationEstimate& estimate) override;
  void on_innovation(const pipeline::InnovationReport& report) override;

 private:
  Follower& to_;
  std::vector<std::optional<frame::Position>> origins_;  ///< by estimator
};

}  // namespace drydock::host
