#pragma once

#include <Eigen/Geometry>

#include "estimators/navigation/increments.hpp"

namespace drydock::navigation {

template <class Real>
void BasicIncrementSum<Real>::add(const Vector& angle, const Vector& velocity, double dt) {
  const Vector turned = angle_ + last_angle_ / 6, gained = velocity_ + last_velocity_ / 6;
  coning_ += 0.5 * turned.cross(angle);                               // eq. (N1)
  sculling_ += 0.5 * (turned.cross(velocity) + gained.cross(angle));  // eq. (N2)
  angle_ += angle;
  velocity_ += velocity;
  last_angle_ = angle;
  last_velocity_ = velocity;
  dt_ += dt;
  ++samples_;
}

template <class Real>
BasicIncrements<Real> BasicIncrementSum<Real>::take() {
  const Vector turned = angle_.cross(velocity_);
  BasicIncrements<Real> sum{angle_ + coning_,
                            velocity_ + turned / 2 + angle_.cross(turned) / 6 + sculling_, dt_};
  angle_.setZero();
  velocity_.setZero();
  coning_.setZero();
  sculling_.setZero();
  dt_ = 0;
  samples_ = 0;
  return sum;
}

}  // namespace drydock::navigation
