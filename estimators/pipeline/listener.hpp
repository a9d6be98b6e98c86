#pragma once

#include "estimators/navigation/innovation.hpp"
#include "estimators/pipeline/estimate.hpp"
#include "estimators/pipeline/inertial/navigation_estimate.hpp"

namespace drydock::pipeline {

/// The innovations of a measurement, used or not. The rows of a velocity are body axes, m/s; of a
/// speed log ahead, m/s; of a depth down, m; of a position north, east, down, m.
struct InnovationReport {
  Stamp valid_at{};  ///< of the measurement
  std::uint16_t estimator = 0, device = 0;
  navigation::Innovations rows;
};

/// Receives the estimates in the call that produced them. Must outlive the pipeline.
class EstimateListener {
 public:
  virtual ~EstimateListener() = default;
  virtual void on_attitude(const AttitudeEstimate& estimate) = 0;
  virtual void on_navigation(const NavigationEstimate&) {}
  virtual void on_innovation(const InnovationReport&) {}
};

}  // namespace drydock::pipeline
