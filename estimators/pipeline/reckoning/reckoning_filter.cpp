#include "estimators/pipeline/reckoning/reckoning_filter.hpp"

#include <cmath>

namespace drydock::pipeline {

using Eigen::Matrix2d;
using Eigen::Vector2d;

namespace {

double square(double x) { return x * x; }

/// Turned by 90 degrees to the right: how a velocity changes with its heading.
Vector2d across(const Vector2d& v) { return {-v.y(), v.x()}; }

}  // namespace

ReckoningFilter::ReckoningFilter(const ReckoningErrors& errors) : sigmas_(errors) {
  Vector6 sigmas;
  sigmas << errors.position_m, errors.position_m, errors.heading_rad, errors.scale,
      errors.current_mps, errors.current_mps;
  covariance_ = sigmas.cwiseAbs2().asDiagonal();
}

Vector2d ReckoningFilter::over_ground(const Vector2d& measured, SpeedOver over) const {
  const Eigen::Rotation2Dd turn(errors_(2));
  return over == SpeedOver::ground ? Vector2d((1 + errors_(3)) * (turn * measured))
                                   : Vector2d(turn * (measured + errors_.tail<2>()));
}

Vector2d ReckoningFilter::as_measured(const Vector2d& ground, SpeedOver over) const {
  const Vector2d turned = Eigen::Rotation2Dd(-errors_(2)) * ground;
  return over == SpeedOver::ground ? Vector2d(turned / (1 + errors_(3)))
                                   : Vector2d(turned - errors_.tail<2>());
}

Eigen::Matrix<double, 2, 6> ReckoningFilter::sensitivity(const Vector2d& measured,
                                                         SpeedOver over) const {
  const Vector2d v = over_ground(measured, over);
  Eigen::Matrix<double, 2, 6> by_error = Eigen::Matrix<double, 2, 6>::Zero();
  by_error.col(2) = across(v);
  if (over == SpeedOver::ground)
    by_error.col(3) = v / (1 + errors_(3));
  else
    by_error.rightCols<2>() = Eigen::Rotation2Dd(errors_(2)).matrix();
  return by_error;
}

Vector2d ReckoningFilter::current() const {
  return Eigen::Rotation2Dd(errors_(2)) * errors_.tail<2>();
}

Vector2d ReckoningFilter::current_sigma() const {
  const auto by_error = sensitivity(Vector2d::Zero(), SpeedOver::water);
  return (by_error * covariance_ * by_error.transpose()).diagonal().cwiseMax(0).cwiseSqrt();
}

double ReckoningFilter::noise_mps(SpeedOver over) const {
  return over == SpeedOver::ground ? sigmas_.velocity_mps : sigmas_.water_speed_mps;
}

// Each speed counts for half of the intervals on both sides. Between two known speeds the speed
// wanders as a Brownian bridge, whose integral has the variance q T^3 / 12.
Vector2d ReckoningFilter::move(const Vector2d& mean, double dt, SpeedOver over) {
  return way(mean, dt, over, square(sigmas_.wander) * std::pow(dt, 3) / 12);
}

// Brownian motion that ends at a known speed: the variance of its integral is q T^3 / 3.
Vector2d ReckoningFilter::move_before(const Vector2d& first, double dt, SpeedOver over) {
  return way(first, dt, over, square(sigmas_.wander) * std::pow(dt, 3) / 3);
}

Vector2d ReckoningFilter::way(const Vector2d& mean, double dt, SpeedOver over, double wandered) {
  Matrix6 transition = Matrix6::Identity();
  transition.topRows<2>() += dt * sensitivity(mean, over);
  covariance_ = transition * covariance_ * transition.transpose();
  covariance_.diagonal().head<2>().array() += square(noise_mps(over) * dt) + wandered;
  return dt * over_ground(mean, over);
}

Matrix2d ReckoningFilter::velocity_covariance(const Vector2d& measured, SpeedOver over) const {
  const auto by_error = sensitivity(measured, over);
  return by_error * covariance_ * by_error.transpose() +
         square(noise_mps(over)) * Matrix2d::Identity();
}

// The heading has no part in it: both speeds are turned by the same one, and so is the current.
void ReckoningFilter::compare(const Vector2d& ground, const Vector2d& water) {
  const double variance = square(sigmas_.velocity_mps) + square(sigmas_.water_speed_mps);
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    Row h = Row::Unit(4 + axis);
    h(3) = -ground(axis);
    update(h, ground(axis) - water(axis) - (h * errors_).value(), variance);
  }
}

navigation::Innovations ReckoningFilter::fix(Vector2d& offset, double sigma_m) {
  navigation::Innovations rows;
  for (Eigen::Index axis = 0; axis < 2; ++axis)
    rows.push_back(update(Row::Unit(axis), offset(axis) - errors_(axis), square(sigma_m)));
  offset = errors_.head<2>();
  errors_.head<2>().setZero();
  return rows;
}

navigation::Innovation ReckoningFilter::update(const Row& h, double innovation, double variance) {
  const Vector6 cross = covariance_ * h.transpose();
  const double expected = (h * cross).value() + variance;
  const Vector6 gain = cross / expected;
  errors_ += gain * innovation;
  covariance_ -= gain * cross.transpose();
  covariance_ = (covariance_ + covariance_.transpose().eval()) / 2;
  return {innovation, std::sqrt(expected), true};
}

}  // namespace drydock::pipeline
