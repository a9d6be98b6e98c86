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
  const Vector2d turned = Eigen::Rotation2Dd(errors_(2)) * measured;
  return over == SpeedOver::ground ? Vector2d((1 + errors_(3)) * turned)
                                   : Vector2d(turned + errors_.tail<2>());
}

Eigen::Matrix<double, 2, 6> ReckoningFilter::sensitivity(const Vector2d& measured,
                                                         SpeedOver over) const {
  const Vector2d v = over_ground(measured, over);
  Eigen::Matrix<double, 2, 6> by_error = Eigen::Matrix<double, 2, 6>::Zero();
  if (over == SpeedOver::ground) {
    by_error.col(2) = across(v);
    by_error.col(3) = v;
  } else {
    by_error.col(2) = across(v - errors_.tail<2>());
    by_error.rightCols<2>().setIdentity();
  }
  return by_error;
}

double ReckoningFilter::noise_mps(SpeedOver over) const {
  return over == SpeedOver::ground ? sigmas_.velocity_mps : sigmas_.water_speed_mps;
}

Vector2d ReckoningFilter::move(const Vector2d& mean, double dt, SpeedOver over) {
  Matrix6 transition = Matrix6::Identity();
  transition.topRows<2>() += dt * sensitivity(mean, over);
  covariance_ = transition * covariance_ * transition.transpose();
  // Each speed counts for half of the intervals on both sides. Between two known speeds the speed
  // wanders as a Brownian bridge, whose integral has the variance q T^3 / 12.
  const double variance =
      square(noise_mps(over) * dt) + square(sigmas_.wander) * std::pow(dt, 3) / 12;
  covariance_.diagonal().head<2>().array() += variance;
  return dt * over_ground(mean, over);
}

Matrix2d ReckoningFilter::velocity_covariance(const Vector2d& measured, SpeedOver over) const {
  const auto by_error = sensitivity(measured, over);
  return by_error * covariance_ * by_error.transpose() +
         square(noise_mps(over)) * Matrix2d::Identity();
}

void ReckoningFilter::compare(const Vector2d& ground, const Vector2d& water) {
  const Vector2d difference =
      over_ground(ground, SpeedOver::ground) - over_ground(water, SpeedOver::water);
  const Eigen::Matrix<double, 2, 6> by_error =
      sensitivity(water, SpeedOver::water) - sensitivity(ground, SpeedOver::ground);
  const double variance = square(sigmas_.velocity_mps) + square(sigmas_.water_speed_mps);
  const Vector6 before = errors_;
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    const Row h = by_error.row(axis);
    update(h, difference(axis) - (h * (errors_ - before)).value(), variance);
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
