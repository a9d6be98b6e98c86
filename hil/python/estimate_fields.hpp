#pragma once

#include <cmath>

#include "drivers/host/follower.hpp"
#include "drivers/wire/fields.hpp"

namespace drydock::host {

/// Names of an estimate's values in tables. Angles are in degrees; sigma is one standard deviation.
/// Those from `latitude_deg` on only come from an estimator that navigates.
template <class Field>
void visit_fields(const Estimate& estimate, Field&& field) {
  using wire::degrees;
  const auto& attitude = estimate.attitude;
  const auto& integrity = estimate.integrity;
  field("valid_at_ns", attitude.valid_at.time_since_epoch().count());
  field("valid", integrity.valid);
  field("roll_deg", degrees(attitude.roll_rad));
  field("pitch_deg", degrees(attitude.pitch_rad));
  field("heading_deg", degrees(attitude.yaw_rad));
  field("roll_sigma_deg", degrees(std::sqrt(attitude.covariance(0, 0))));
  field("pitch_sigma_deg", degrees(std::sqrt(attitude.covariance(1, 1))));
  field("roll_bound_deg", degrees(integrity.roll_bound_rad));
  field("pitch_bound_deg", degrees(integrity.pitch_bound_rad));
  field("heading_bound_deg", degrees(integrity.heading_bound_rad));
  field("horizontal_bound_m", integrity.horizontal_bound_m);
  if (!estimate.navigation) return;
  const auto& navigation = *estimate.navigation;
  const Eigen::Matrix<double, 9, 1> sigma = navigation.covariance.diagonal().cwiseSqrt();
  field("latitude_deg", degrees(navigation.latitude_rad));
  field("longitude_deg", degrees(navigation.longitude_rad));
  field("height_m", navigation.height_m);
  field("offset_ned_m", navigation.offset_ned);
  field("velocity_ned_mps", navigation.velocity_ned);
  field("position_sigma_m", Eigen::Vector3d(sigma.head<3>()));
  field("velocity_sigma_mps", Eigen::Vector3d(sigma.segment<3>(3)));
}

}  // namespace drydock::host
