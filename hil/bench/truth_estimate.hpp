#pragma once

#include "estimators/pipeline/inertial/navigation_estimate.hpp"
#include "hil/motion/truth.hpp"

namespace drydock::bench {

/// The truth in the form of an estimate, without a covariance.
inline pipeline::NavigationEstimate as_estimate(const motion::Truth& truth) {
  pipeline::NavigationEstimate estimate;
  estimate.valid_at = truth.at;
  estimate.position = {truth.latitude_rad, truth.longitude_rad, truth.height_m};
  estimate.velocity_ned = truth.velocity_ned;
  estimate.body_to_ned = truth.body_to_ned;
  return estimate;
}

}  // namespace drydock::bench
