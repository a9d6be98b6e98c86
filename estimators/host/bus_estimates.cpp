#include "estimators/host/bus_estimates.hpp"

#include <cmath>

namespace drydock::host {
namespace {

bus::Integrity bus_integrity(const pipeline::Integrity& integrity) {
  return {.valid = integrity.valid,
          .roll_bound_rad = integrity.roll_bound_rad,
          .pitch_bound_rad = integrity.pitch_bound_rad,
          .heading_bound_rad = integrity.heading_bound_rad,
          .horizontal_bound_m = integrity.horizontal_bound_m};
}

/// An estimate without a height is told north and east, and no down.
Eigen::Vector3d offset_of(frame::Position from, frame::Position to) {
  const double down = from.height_m - to.height_m;
  if (!std::isnan(down)) return frame::ned_offset(from, to);
  from.height_m = to.height_m = std::isnan(from.height_m) ? 0 : from.height_m;
  Eigen::Vector3d offset = frame::ned_offset(from, to);
  offset.z() = down;
  return offset;
}

}  // namespace

Estimate bus_estimate(const pipeline::AttitudeEstimate& estimate) {
  return {.estimator = estimate.estimator,
          .attitude = {.valid_at = estimate.valid_at,
                       .roll_rad = estimate.roll_rad,
                       .pitch_rad = estimate.pitch_rad,
                       .yaw_rad = estimate.yaw_rad,
                       .covariance = estimate.covariance},
          .integrity = bus_integrity(estimate.integrity)};
}

Estimate bus_estimate(const pipeline::NavigationEstimate& estimate, const frame::Position& origin) {
  Estimate told = bus_estimate(pipeline::attitude_of(estimate));
  told.navigation = {.valid_at = estimate.valid_at,
                     .latitude_rad = estimate.position.latitude_rad,
                     .longitude_rad = estimate.position.longitude_rad,
                     .height_m = estimate.position.height_m,
                     .offset_ned = offset_of(origin, estimate.position),
                     .velocity_ned = estimate.velocity_ned,
                     .body_to_ned = estimate.body_to_ned,
                     .covariance = estimate.covariance};
  if (estimate.current)
    told.current = {estimate.current->north_east_mps, estimate.current->sigma_mps};
  return told;
}

bus::Innovation bus_innovation(const pipeline::InnovationReport& report) {
  bus::Innovation innovation{report.valid_at, report.estimator, report.device, {}};
  for (const auto& row : report.rows) innovation.rows.push_back({row.value, row.sigma, row.used});
  return innovation;
}

void EstimateTeller::on_attitude(const pipeline::AttitudeEstimate& estimate) {
  to_.on_estimate(bus_estimate(estimate));
}

void EstimateTeller::on_navigation(const pipeline::NavigationEstimate& estimate) {
  if (origins_.size() <= estimate.estimator) origins_.resize(estimate.estimator + 1U);
  auto& origin = origins_[estimate.estimator];
  if (!origin || std::isnan(origin->latitude_rad)) origin = estimate.position;
  if (std::isnan(origin->height_m)) origin->height_m = estimate.position.height_m;
  to_.on_estimate(bus_estimate(estimate, *origin));
}

void EstimateTeller::on_innovation(const pipeline::InnovationReport& report) {
  to_.on_innovation(bus_innovation(report));
}

}  // namespace drydock::host
