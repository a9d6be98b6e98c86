// What the sensors beside the IMU give to the navigation: each value is checked and waits for the
// step at whose time it was true.
#include <cmath>
#include <numbers>

#include "drivers/measurement/axis_sigma.hpp"
#include "estimators/pipeline/inertial/navigation_estimator.hpp"

namespace drydock::pipeline {

using Eigen::Vector3d;
using measurement::seconds;

namespace {

bool is_within(const Vector3d& v, double limit) {
  return v.allFinite() && v.cwiseAbs().maxCoeff() <= limit;
}

}  // namespace

Outcome NavigationEstimator::take(const measurement::WaterSpeed& speed, EstimateListener&) {
  const auto& log = options_.log;
  if (!log || speed.origin.device != log->device || !speed.longitudinal_mps) return Outcome::unused;
  // This comparison is false for NaN too.
  if (!(std::abs(*speed.longitudinal_mps) <= max_speed_mps)) return Outcome::refused;
  return wait_for_step({.kind = Aid::log,
                        .sensor = &*log,
                        .valid_at = speed.origin.valid_at,
                        .value = {*speed.longitudinal_mps, 0, 0},
                        .position = {}});
}

Outcome NavigationEstimator::take(const measurement::BottomVelocity& track, EstimateListener&) {
  const auto& ground = options_.ground;
  if (!ground || track.origin.device != ground->device || !track.velocity) return Outcome::unused;
  if (!is_within(*track.velocity, max_speed_mps)) return Outcome::refused;
  return wait_for_step({.kind = Aid::ground,
                        .sensor = &*ground,
                        .valid_at = track.origin.valid_at,
                        .value = *track.velocity,
                        .position = {}});
}

Outcome NavigationEstimator::take(const measurement::AttitudeSample& compass, EstimateListener&) {
  const auto& heading = options_.heading;
  if (!heading || compass.origin.device != heading->device || !compass.true_heading_rad)
    return Outcome::unused;
  constexpr double circle_rad = 2 * std::numbers::pi;
  // This comparison is false for NaN too.
  if (!(std::abs(*compass.true_heading_rad) <= circle_rad)) return Outcome::refused;
  return wait_for_step({.kind = Aid::heading,
                        .sensor = &*heading,
                        .valid_at = compass.origin.valid_at,
                        .value = {*compass.true_heading_rad, 0, 0},
                        .position = {}});
}

Outcome NavigationEstimator::take(const measurement::GnssFix& fix, EstimateListener&) {
  constexpr double unknown_height_sigma_m = 1e4;
  const auto& gnss = options_.gnss;
  if (!gnss || fix.origin.device != gnss->device || !fix.position) return Outcome::unused;
  const double horizontal = measurement::axis_sigma_m(fix).value_or(options_.position_sigma_m);
  double vertical = fix.vertical_accuracy_m.value_or(options_.position_height_sigma_m);
  frame::Position position{fix.position->latitude_rad, fix.position->longitude_rad,
                           filter_->state().position.height_m};
  if (fix.ellipsoidal_height_m) {
    position.height_m = *fix.ellipsoidal_height_m;
  } else if (fix.mean_sea_level_height_m) {
    position.height_m = *fix.mean_sea_level_height_m + options_.sea_level_m;
  } else {
    vertical = unknown_height_sigma_m;
  }
  const Vector3d sigma{horizontal, horizontal, vertical};
  const Vector3d all{position.latitude_rad, position.longitude_rad, position.height_m};
  if (!sigma.allFinite() || !(sigma.minCoeff() > 0) || !all.allFinite()) return Outcome::refused;
  return wait_for_step({.kind = Aid::position,
                        .sensor = &*gnss,
                        .valid_at = fix.origin.valid_at,
                        .value = sigma,
                        .position = position});
}

Outcome NavigationEstimator::wait_for_step(const Aiding& aiding) {
  if (!running()) return Outcome::unused;
  const auto behind = now_ - aiding.valid_at;
  if (behind > max_age_) return Outcome::late;
  if (behind < -max_age_) return Outcome::unused;  // the IMU is silent
  if (waiting_.size() == waiting_.capacity()) return Outcome::refused;
  waiting_.push_back(aiding);
  return behind > period_ ? Outcome::delayed : Outcome::accepted;
}

Outcome NavigationEstimator::take(const measurement::DepthSample& sample,
                                  EstimateListener& listener) {
  const auto& depth = options_.depth;
  if (!depth || sample.origin.device != depth->device || !sample.depth_m || !running())
    return Outcome::unused;
  if (!std::isfinite(*sample.depth_m)) return Outcome::refused;
  const auto behind = now_ - sample.origin.valid_at;
  if (std::chrono::abs(behind) > max_age_)
    return behind.count() > 0 ? Outcome::late : Outcome::unused;
  const auto& state = filter_->state();
  const double arm_down = (state.body_to_ned * depth->lever).z();
  const double height = options_.sea_level_m - *sample.depth_m + arm_down;
  Innovations rows = filter_->add_height(height - state.velocity_ned.z() * seconds(behind));
  for (auto& row : rows) row.value = -row.value;  // depth is down, the height is up
  tell(Aid::depth, sample.origin.valid_at, depth->device, rows, listener);
  note_fed_by(depth->device);
  return behind > period_ ? Outcome::delayed : Outcome::accepted;
}

Outcome NavigationEstimator::take(const measurement::ActuatorState& state, EstimateListener&) {
  if (!options_.actuators || state.origin.device != *options_.actuators) return Outcome::unused;
  const auto known = [](const std::optional<double>& value, double& into, double unit) {
    if (value && std::isfinite(*value)) into = *value * unit;
  };
  known(state.rudder_rad, control_.delta_r, 1);
  known(state.stern_plane_rad, control_.delta_s, 1);
  known(state.bow_plane_rad, control_.delta_b, 1);
  known(state.propeller_radps, control_.u_c, options_.advance_m);
  filter_->control(control_);
  if (vehicle_) vehicle_->control(control_, state.origin.valid_at);
  note_fed_by(*options_.actuators);
  return Outcome::accepted;
}

}  // namespace drydock::pipeline
