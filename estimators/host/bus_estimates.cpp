#include "estimators/host/bus_estimates.hpp"

namespace drydock::host {

bus::Attitude bus_attitude(const pipeline::AttitudeEstimate& estimate) {
  return {.valid_at = estimate.valid_at,
          .roll_rad = estimate.roll_rad,
          .pitch_rad = estimate.pitch_rad,
          .yaw_rad = estimate.yaw_rad,
          .covariance = estimate.covariance};
}

bus::Innovation bus_innovation(const pipeline::InnovationReport& report) {
  bus::Innovation innovation{report.valid_at, report.estimator, report.device, {}};
  for (const auto& row : report.rows) innovation.rows.push_back({row.value, row.sigma, row.used});
  return innovation;
}

bus::Navigation BusNavigation::operator()(const pipeline::NavigationEstimate& estimate) {
  if (origins_.size() <= estimate.estimator) origins_.resize(estimate.estimator + 1U);
  auto& origin = origins_[estimate.estimator];
  if (!origin) origin = estimate.position;
  return {.valid_at = estimate.valid_at,
          .latitude_rad = estimate.position.latitude_rad,
          .longitude_rad = estimate.position.longitude_rad,
          .height_m = estimate.position.height_m,
          .offset_ned = frame::ned_offset(*origin, estimate.position),
          .velocity_ned = estimate.velocity_ned,
          .body_to_ned = estimate.body_to_ned,
          .covariance = estimate.covariance};
}

}  // namespace drydock::host
