#include "estimators/navigation/increments.hpp"

#include <Eigen/Geometry>

namespace drydock::navigation {

using Eigen::Vector3d;

void IncrementSum::add(const Vector3d& angle, const Vector3d& velocity, double dt) {
  const Vector3d turned = angle_ + last_angle_ / 6, gained = velocity_ + last_velocity_ / 6;
  coning_ += 0.5 * turned.cross(angle);                               // eq. (N1)
  sculling_ += 0.5 * (turned.cross(velocity) + gained.cross(angle));  // eq. (N2)
  angle_ += angle;
  velocity_ += velocity;
  last_angle_ = angle;
  last_velocity_ = velocity;
  dt_ += dt;
  ++samples_;
}

Increments IncrementSum::take() {
  const Vector3d turned = angle_.cross(velocity_);
  Increments sum{angle_ + coning_, velocity_ + turned / 2 + angle_.cross(turned) / 6 + sculling_,
                 dt_};
  angle_.setZero();
  velocity_.setZero();
  coning_.setZero();
  sculling_.setZero();
  dt_ = 0;
  samples_ = 0;
  return sum;
}

}  // namespace drydock::navigation
