#include "estimators/velocity/coupled_navigation.hpp"

#include <cmath>

#include "estimators/frame/attitude.hpp"
#include "estimators/frame/earth.hpp"
#include "estimators/velocity/hypotheses.hpp"

namespace drydock::velocity {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using navigation::position_error;
using navigation::velocity_error;

namespace {

Eigen::Vector4d absence_prior(const CoupledOptions& o) {
  return {o.current_mps, o.current_mps, o.log_scale, o.log_bias_mps};
}

CoupledNavigation::Filter::Vector coupled_sigma(const CoupledOptions& o,
                                                const frame::Position& at) {
  CoupledNavigation::Filter::Vector sigma;
  sigma << navigation::initial_sigma(o.navigation, at), absence_prior(o),
      SwayModel::PerCause::Constant(o.force_error);
  return sigma;
}

CoupledNavigation::Filter::Vector coupled_noise(const CoupledOptions& o) {
  CoupledNavigation::Filter::Vector noise = CoupledNavigation::Filter::Vector::Zero();
  noise.head<15>() = navigation::noise_density(o.navigation);
  noise(position_error + 2) = 0;  // this is the noise of a height loop, which is not used here
  return noise;
}

}  // namespace

CoupledNavigation::CoupledNavigation(const navigation::NavigationState& start,
                                     const hydrodynamics::Vehicle& vehicle,
                                     const CoupledOptions& options)
    : options_(options),
      sdins_(start),
      filter_(coupled_sigma(options, start.position)),
      noise_(coupled_noise(options)),
      sway_(vehicle) {}

void CoupledNavigation::step(const hydrodynamics::Control& control) {
  const navigation::Increments increments = sum_.take();
  const double dt = increments.dt;
  if (!(dt > 0)) return;
  const Vector3d before = velocity_through_water();
  const double sinking = dt * state().velocity_ned.z();
  sdins_.step(increments);
  filter_.propagate(navigation::error_dynamics(sdins_.state(), sdins_.force_ned()), dt, noise_);

  const Matrix3d ned_to_body = state().body_to_ned.toRotationMatrix().transpose();
  const Vector3d earth_rate = ned_to_body * frame::earth_rate_ned(state().position.latitude_rad);
  const Vector3d rate = increments.rotation / dt - earth_rate;
  const Vector3d after = velocity_through_water();
  sway_.step({.u = (before.x() + after.x()) / 2,
              .w = (before.z() + after.z()) / 2,
              .rate = rate,
              .rate_change = moving_ ? Vector3d{(rate - last_rate_) / dt} : Vector3d::Zero(),
              .earth_rate = earth_rate,
              .down_y = ned_to_body(1, 2)},
             control, dt);
  last_rate_ = rate;
  moving_ = true;

  // Eq. (V6).
  Vector row = water_rows().row(1);
  row.segment<SwayModel::causes>(force_error) = -sway_.sensitivity();
  update(row, after.y() - sway_.v(), options_.sway_noise_m * options_.sway_noise_m / dt);

  update_height(sinking);
  if (since_ground_s_ >= 0 && (since_ground_s_ += dt) > options_.ground_lost_s) weigh_hypotheses();
}

void CoupledNavigation::update_height(double sinking_m) {
  if (heights_ == 0) return;
  const double height = height_sum_ / heights_ - sinking_m;
  update(Vector::Unit(position_error + 2), state().position.height_m - height,
         options_.depth_sigma_m * options_.depth_sigma_m / heights_);
  height_sum_ = heights_ = 0;
}

void CoupledNavigation::update_log(double speed_mps) {
  innovations_.clear();
  constexpr double slowest = 1e-3;  // below it the direction of the velocity is undefined
  const Vector3d velocity = velocity_through_water();
  const double speed = velocity.norm();
  if (speed < slowest) return;
  update_by_log(water_rows().transpose() * velocity / speed, speed, speed_mps);  // eq. (V7)
}

void CoupledNavigation::update_longitudinal(double mps) {
  innovations_.clear();
  update_by_log(water_rows().row(0), velocity_through_water().x(), mps);  // eq. (V7a)
}

void CoupledNavigation::update_by_log(Vector row, double value, double measured_mps) {
  row *= 1 + log_(0);
  row.segment<2>(log_error) = Vector2d{value, 1};
  const auto expected = filter_.row(row, options_.log_sigma_mps * options_.log_sigma_mps);
  const double innovation = (1 + log_(0)) * value + log_(1) - measured_mps;
  if (passes(innovation, expected.variance)) feed_back(filter_.update(expected, innovation));
}

void CoupledNavigation::update_velocity(const Vector3d& velocity_body) {
  if (since_ground_s_ < 0) reopen_hypotheses();
  since_ground_s_ = 0;
  innovations_.clear();
  const auto rows = navigation::body_velocity_rows(state());
  const Vector3d residual = state().body_to_ned.conjugate() * state().velocity_ned - velocity_body;
  Vector errors = Vector::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    Vector row = Vector::Zero();
    row.segment<6>(velocity_error) = rows.row(axis);
    const auto expected = filter_.row(row, options_.ground_sigma_mps * options_.ground_sigma_mps);
    const double innovation = residual(axis) - row.dot(errors);
    if (passes(innovation, expected.variance)) errors += filter_.update(expected, innovation);
  }
  feed_back(errors);
}

Vector3d CoupledNavigation::velocity_through_water() const {
  return state().body_to_ned.conjugate() *
         (state().velocity_ned - Vector3d{current_.x(), current_.y(), 0});
}

Eigen::Matrix<double, 3, CoupledNavigation::Filter::stored> CoupledNavigation::water_rows() const {
  const Matrix3d ned_to_body = state().body_to_ned.toRotationMatrix().transpose();
  const Vector3d through_water = state().velocity_ned - Vector3d{current_.x(), current_.y(), 0};
  Eigen::Matrix<double, 3, Filter::stored> rows = Eigen::Matrix<double, 3, Filter::stored>::Zero();
  rows.middleCols<3>(velocity_error) = ned_to_body;
  rows.middleCols<3>(navigation::phi) = -ned_to_body * frame::skew(through_water);
  rows.middleCols<2>(current_error) = -ned_to_body.leftCols<2>();
  return rows;
}

void CoupledNavigation::update(const Vector& row, double residual, double variance) {
  feed_back(filter_.update(filter_.row(row, variance), residual));
}

bool CoupledNavigation::passes(double innovation, double variance) {
  const double square = innovation * innovation / variance;
  const bool outside = navigation::outside_gate(square, options_.navigation.gate_sigma);
  innovations_.push_back({-innovation, std::sqrt(variance), !outside});
  if (outside) {
    ++rejected_;
    return false;
  }
  taken_.add(square);
  return true;
}

bool CoupledNavigation::passes_height(double height_m) {
  const double variance = filter_.covariance()(position_error + 2, position_error + 2) +
                          options_.depth_sigma_m * options_.depth_sigma_m;
  return passes(state().position.height_m - height_m, variance);
}

void CoupledNavigation::feed_back(const Vector& errors) {
  sdins_.correct(errors.segment<3>(position_error), errors.segment<3>(velocity_error),
                 errors.segment<3>(navigation::phi));
  gyro_bias_ += errors.segment<3>(navigation::gyro_bias);
  accel_bias_ += errors.segment<3>(navigation::accel_bias);
  current_ -= errors.segment<2>(current_error);
  log_ -= errors.segment<2>(log_error);
  sway_.correct(errors.segment<SwayModel::causes>(force_error));
}

void CoupledNavigation::weigh_hypotheses() {
  Eigen::Vector4d values;
  values << current_, log_;
  open_ = Open{values, filter_.covariance().block<4, 4>(current_error, current_error)};
  feed_back(weigh_absence(filter_, current_error, values, absence_prior(options_)).errors);
  since_ground_s_ = -1;
}

/// Restores the estimates from before the weighing, so that a short loss of the DVL does not lose
/// the knowledge of current and log.
void CoupledNavigation::reopen_hypotheses() {
  if (!open_) return;
  auto& covariance = filter_.covariance();
  covariance.middleRows<4>(current_error).setZero();
  covariance.middleCols<4>(current_error).setZero();
  covariance.block<4, 4>(current_error, current_error) = open_->covariance;
  current_ = open_->values.head<2>();
  log_ = open_->values.tail<2>();
  open_.reset();
}

}  // namespace drydock::velocity
