#pragma once

#include "estimators/frame/earth.hpp"
#include "estimators/frame/skew.hpp"
#include "estimators/navigation/aided_navigation_body.hpp"
#include "estimators/velocity/coupled_navigation.hpp"
#include "estimators/velocity/hypotheses.hpp"
#include "estimators/velocity/sway_model_body.hpp"

namespace drydock::velocity {

Eigen::Vector4d absence_prior(const CoupledOptions& o);

/// The correction by weigh_absence(), run by run: a filter is weighed once or twice in hours.
/// On plain arrays, for units with other registers. `covariance` becomes that of the mixture.
void weigh_absence_of_run(double* covariance, const double* values, const CoupledOptions& options,
                          double* errors);

template <class Real>
typename BasicCoupledNavigation<Real>::Filter::Vector weighed_errors(
    typename BasicCoupledNavigation<Real>::Filter& filter, const Eigen::Vector4<Real>& values,
    const CoupledOptions& options) {
  using lanes::lane, lanes::set_lane;
  using Filter = typename BasicCoupledNavigation<Real>::Filter;
  constexpr int size = Filter::stored, cells = size * size;
  typename Filter::Vector errors;
  Real* const covariance = filter.covariance().data();
  for (int run = 0; run < lanes::width<Real>; ++run) {
    double of_run[cells], value[4], error[size];
    for (int i = 0; i < cells; ++i) of_run[i] = lane(covariance[i], run);
    for (int i = 0; i < 4; ++i) value[i] = lane(values(i), run);
    weigh_absence_of_run(of_run, value, options, error);
    for (int i = 0; i < cells; ++i) set_lane(covariance[i], run, of_run[i]);
    for (int i = 0; i < size; ++i) set_lane(errors(i), run, error[i]);
  }
  return errors;
}

template <class Real>
typename BasicCoupledNavigation<Real>::Filter::Vector coupled_sigma(
    const CoupledOptions& o, const frame::BasicPosition<Real>& at) {
  typename BasicCoupledNavigation<Real>::Filter::Vector sigma;
  sigma << navigation::basic_initial_sigma<Real>(o.navigation, at),
      absence_prior(o).template cast<Real>(),
      BasicSwayModel<Real>::PerCause::Constant(o.force_error);
  return sigma;
}

template <class Real>
typename BasicCoupledNavigation<Real>::Filter::Vector coupled_noise(const CoupledOptions& o) {
  using Vector = typename BasicCoupledNavigation<Real>::Filter::Vector;
  Vector noise = Vector::Zero();
  noise.template head<15>() = navigation::noise_density(o.navigation).template cast<Real>();
  noise(navigation::position_error + 2) =
      0;  // this is the noise of a height loop, which is not used here
  return noise;
}

template <class Real>
BasicCoupledNavigation<Real>::BasicCoupledNavigation(
    const State& start, const hydrodynamics::BasicVehicle<Real>& vehicle,
    const CoupledOptions& options)
    : options_(options),
      sdins_(start),
      filter_(coupled_sigma<Real>(options, start.position)),
      noise_(coupled_noise<Real>(options)),
      sway_(vehicle) {}

template <class Real>
void BasicCoupledNavigation<Real>::step(const hydrodynamics::Control& control) {
  const navigation::BasicIncrements<Real> increments = sum_.take();
  const double dt = increments.dt;
  if (!(dt > 0)) return;
  const Vector3 before = velocity_through_water();
  const Real sinking = dt * state().velocity_ned.z();
  sdins_.step(increments);
  const frame::BasicLocalEarth<Real> earth =
      frame::local_earth(state().position.latitude_rad, state().position.height_m);
  filter_.propagate(navigation::error_dynamics(sdins_.state(), earth, sdins_.force_ned(), {}), dt,
                    noise_);

  const Eigen::Matrix3<Real> ned_to_body = state().body_to_ned.toRotationMatrix().transpose();
  const Vector3 earth_rate = ned_to_body * earth.earth_rate_ned();
  const Vector3 rate = increments.rotation / dt - earth_rate;
  const Vector3 after = velocity_through_water();
  sway_.step({.u = (before.x() + after.x()) / 2,
              .w = (before.z() + after.z()) / 2,
              .rate = rate,
              .rate_change = moving_ ? Vector3{(rate - last_rate_) / dt} : Vector3::Zero(),
              .earth_rate = earth_rate,
              .down_y = ned_to_body(1, 2)},
             control, dt);
  last_rate_ = rate;
  moving_ = true;

  // Eq. (V6).
  Vector row = water_rows().row(1);
  row.template segment<Sway::causes>(force_error) = -sway_.sensitivity();
  update(row, after.y() - sway_.v(), options_.sway_noise_m * options_.sway_noise_m / dt);

  update_height(sinking);
  if (since_ground_s_ >= 0 && (since_ground_s_ += dt) > options_.ground_lost_s) weigh_hypotheses();
}

template <class Real>
void BasicCoupledNavigation<Real>::update_height(const Real& sinking_m) {
  if (heights_ == 0) return;
  const Real height = height_sum_ / heights_ - sinking_m;
  update(Vector::Unit(navigation::position_error + 2), state().position.height_m - height,
         options_.depth_sigma_m * options_.depth_sigma_m / heights_);
  height_sum_ = heights_ = 0;
}

template <class Real>
void BasicCoupledNavigation<Real>::update_log(const Real& speed_mps) {
  innovations_.clear();
  constexpr double slowest = 1e-3;  // below it the direction of the velocity is undefined
  const Vector3 velocity = velocity_through_water();
  const Real speed = velocity.norm();
  if constexpr (lanes::alone<Real>) {
    if (speed < slowest) return;
  }
  update_by_log(water_rows().transpose() * velocity / speed, speed, speed_mps);  // eq. (V7)
}

template <class Real>
void BasicCoupledNavigation<Real>::update_longitudinal(const Real& mps) {
  innovations_.clear();
  update_by_log(water_rows().row(0), velocity_through_water().x(), mps);  // eq. (V7a)
}

template <class Real>
void BasicCoupledNavigation<Real>::update_by_log(Vector row, const Real& value,
                                                 const Real& measured_mps) {
  row *= 1 + log_(0);
  row.template segment<2>(log_error) = Eigen::Vector2<Real>{value, 1};
  const auto expected = filter_.row(row, options_.log_sigma_mps * options_.log_sigma_mps);
  const Real innovation = (1 + log_(0)) * value + log_(1) - measured_mps;
  if constexpr (lanes::alone<Real>) {
    if (!passes(innovation, expected.variance)) return;
  }
  feed_back(filter_.update(expected, innovation));
}

template <class Real>
void BasicCoupledNavigation<Real>::update_velocity(const Vector3& velocity_body) {
  if (since_ground_s_ < 0) reopen_hypotheses();
  since_ground_s_ = 0;
  innovations_.clear();
  const auto rows = navigation::body_velocity_rows(state());
  const Vector3 residual = state().body_to_ned.conjugate() * state().velocity_ned - velocity_body;
  Vector errors = Vector::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    Vector row = Vector::Zero();
    row.template segment<6>(navigation::velocity_error) = rows.row(axis);
    const auto expected = filter_.row(row, options_.ground_sigma_mps * options_.ground_sigma_mps);
    const Real innovation = residual(axis) - row.dot(errors);
    if constexpr (lanes::alone<Real>) {
      if (!passes(innovation, expected.variance)) continue;
    }
    errors += filter_.update(expected, innovation);
  }
  feed_back(errors);
}

template <class Real>
Eigen::Vector3<Real> BasicCoupledNavigation<Real>::velocity_through_water() const {
  return state().body_to_ned.conjugate() *
         (state().velocity_ned - Vector3{current_.x(), current_.y(), 0});
}

template <class Real>
Eigen::Matrix<Real, 3, BasicCoupledNavigation<Real>::Filter::stored>
BasicCoupledNavigation<Real>::water_rows() const {
  const Eigen::Matrix3<Real> ned_to_body = state().body_to_ned.toRotationMatrix().transpose();
  const Vector3 through_water = state().velocity_ned - Vector3{current_.x(), current_.y(), 0};
  Eigen::Matrix<Real, 3, Filter::stored> rows = Eigen::Matrix<Real, 3, Filter::stored>::Zero();
  rows.template middleCols<3>(navigation::velocity_error) = ned_to_body;
  rows.template middleCols<3>(navigation::phi) = -ned_to_body * frame::skew<Real>(through_water);
  rows.template middleCols<2>(current_error) = -ned_to_body.template leftCols<2>();
  return rows;
}

template <class Real>
void BasicCoupledNavigation<Real>::update(const Vector& row, const Real& residual,
                                          double variance) {
  feed_back(filter_.update(filter_.row(row, variance), residual));
}

template <class Real>
void BasicCoupledNavigation<Real>::feed_back(const Vector& errors) {
  sdins_.correct(errors.template segment<3>(navigation::position_error),
                 errors.template segment<3>(navigation::velocity_error),
                 errors.template segment<3>(navigation::phi));
  gyro_bias_ += errors.template segment<3>(navigation::gyro_bias);
  accel_bias_ += errors.template segment<3>(navigation::accel_bias);
  current_ -= errors.template segment<2>(current_error);
  log_ -= errors.template segment<2>(log_error);
  sway_.correct(errors.template segment<Sway::causes>(force_error));
}

template <class Real>
void BasicCoupledNavigation<Real>::weigh_hypotheses() {
  Eigen::Vector4<Real> values;
  values << current_, log_;
  open_ = Open{values, filter_.covariance().template block<4, 4>(current_error, current_error)};
  feed_back(weighed_errors<Real>(filter_, values, options_));
  since_ground_s_ = -1;
}

/// Restores the estimates from before the weighing, so that a short loss of the DVL does not lose
/// the knowledge of current and log.
template <class Real>
void BasicCoupledNavigation<Real>::reopen_hypotheses() {
  if (!open_) return;
  auto& covariance = filter_.covariance();
  covariance.template middleRows<4>(current_error).setZero();
  covariance.template middleCols<4>(current_error).setZero();
  covariance.template block<4, 4>(current_error, current_error) = open_->covariance;
  current_ = open_->values.template head<2>();
  log_ = open_->values.template tail<2>();
  open_.reset();
}

}  // namespace drydock::velocity
