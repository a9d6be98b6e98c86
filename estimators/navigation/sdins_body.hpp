#pragma once

#include <numbers>

#include "estimators/frame/local_earth_body.hpp"
#include "estimators/navigation/sdins.hpp"

namespace drydock::navigation {

/// As Eigen's, for a length that is not 0.
template <class Real>
void normalize(Eigen::Quaternion<Real>& q) {
  using lanes::sqrt;
  q.coeffs() /= sqrt(q.coeffs().squaredNorm());
}

template <class Real>
Eigen::Quaternion<Real> quaternion_of(const Eigen::Vector3<Real>& rotation) {
  const Real x = rotation.squaredNorm() / 4;  // square of the half angle
  const Real cosine = 1 - x / 2 * (1 - x / 12 * (1 - x / 30 * (1 - x / 56)));
  const Real sinc = 1 - x / 6 * (1 - x / 20 * (1 - x / 42 * (1 - x / 72)));
  const Eigen::Vector3<Real> vector = sinc / 2 * rotation;
  Eigen::Quaternion<Real> q{cosine, vector.x(), vector.y(), vector.z()};
  using lanes::any, lanes::lane, lanes::set_lane;
  if (any(x > 0.01)) {
    for (int run = 0; run < lanes::width<Real>; ++run) {
      if (!(lane(x, run) > 0.01)) continue;
      const Eigen::Quaterniond far =
          far_turn({lane(rotation.x(), run), lane(rotation.y(), run), lane(rotation.z(), run)});
      for (int i = 0; i < 4; ++i) set_lane(q.coeffs()(i), run, far.coeffs()(i));
    }
  }
  return q;
}

template <class Real>
void BasicSdins<Real>::step(const BasicIncrements<Real>& increments,
                            std::optional<Real> reference_height_m) {
  const double dt = increments.dt;
  if (!(dt > 0)) return;
  frame::BasicPosition<Real>& at = state_.position;

  // Rates and gravity are taken in the middle of the step.
  const Vector v_mid = state_.velocity_ned + dt / 2 * acceleration_;
  const Real height_mid = at.height_m - dt / 2 * v_mid.z();
  const frame::BasicLocalEarth<Real> earth = frame::local_earth<Real>(
      at.latitude_rad + dt / 2 * v_mid.x() / (frame::wgs84::semi_major_axis_m + height_mid),
      height_mid);
  const Real north_arc = 1 / (earth.meridian_radius_m + height_mid);
  const Real east_arc = 1 / (earth.transverse_radius_m + height_mid);
  const Vector earth_rate{earth.rate_north, 0, earth.rate_down};
  const Vector transport_rate{v_mid.y() * east_arc, -v_mid.x() * north_arc,
                              -v_mid.y() * east_arc * earth.tan_latitude};
  const Vector frame_turn = (earth_rate + transport_rate) * dt;

  // Eq. (N6): the specific force in the navigation axes at the middle of the step.
  Vector gained = state_.body_to_ned * increments.velocity;
  gained -= 0.5 * frame_turn.cross(gained);
  force_ned_ = gained / dt;
  acceleration_ = force_ned_ - (2 * earth_rate + transport_rate).cross(v_mid);
  acceleration_.z() += earth.gravity_mps2;

  // Eq. (N5).
  Real climb_correction = 0;
  if (reference_height_m) {
    const Real excess = height_mid - *reference_height_m;
    loop_acceleration_ += loop_.k3 * excess * dt;
    acceleration_.z() += loop_.k2 * excess;
    climb_correction = -loop_.k1 * excess;
  }
  acceleration_.z() += loop_acceleration_;

  const Vector v_end = state_.velocity_ned + dt * acceleration_;
  const Vector travelled = dt / 2 * (state_.velocity_ned + v_end);
  at.latitude_rad += travelled.x() * north_arc;
  at.longitude_rad += travelled.y() * east_arc / earth.cos_latitude;
  using lanes::select;
  constexpr double pi = std::numbers::pi;
  at.longitude_rad -= select(at.longitude_rad > pi, 2 * pi, 0.0);
  at.longitude_rad += select(at.longitude_rad < -pi, 2 * pi, 0.0);
  at.height_m += climb_correction * dt - travelled.z();
  state_.velocity_ned = v_end;
  state_.body_to_ned = quaternion_of<Real>(-frame_turn) * state_.body_to_ned *  //
                       quaternion_of<Real>(increments.rotation);
  normalize(state_.body_to_ned);
}

template <class Real>
void BasicSdins<Real>::correct(const Vector& position, const Vector& velocity, const Vector& phi) {
  state_.position.latitude_rad -= position.x();
  state_.position.longitude_rad -= position.y();
  state_.position.height_m -= position.z();
  state_.velocity_ned -= velocity;
  state_.body_to_ned = quaternion_of<Real>(phi) * state_.body_to_ned;
  normalize(state_.body_to_ned);
}

}  // namespace drydock::navigation
