#pragma once

#include "estimators/pipeline/estimate.hpp"
#include "estimators/pipeline/navigation_estimate.hpp"

namespace drydock::pipeline {

/// Takes what the estimators give, in the call that made it. Must outlive the pipeline.
class EstimateListener {
 public:
  virtual ~EstimateListener() = default;
  virtual void on_attitude(const AttitudeEstimate& estimate) = 0;
  virtual void on_navigation(const NavigationEstimate&) {}
};

}  // namespace drydock::pipeline
