#include "estimators/navigation/sdins.hpp"

#include <cmath>
#include <numbers>

#include "estimators/frame/earth.hpp"
#include "estimators/frame/local_earth.hpp"

namespace drydock::navigation {

using Eigen::Quaterniond;
using Eigen::Vector3d;

Quaterniond quaternion_of(const Vector3d& rotation) {
  const double x = rotation.squaredNorm() / 4;  // square of the half angle
  if (x > 0.01) return Quaterniond{Eigen::AngleAxisd{2 * std::sqrt(x), rotation.normalized()}};
  const double cosine = 1 - x / 2 * (1 - x / 12 * (1 - x / 30 * (1 - x / 56)));
  const double sinc = 1 - x / 6 * (1 - x / 20 * (1 - x / 42 * (1 - x / 72)));
  const Vector3d vector = sinc / 2 * rotation;
  return {cosine, vector.x(), vector.y(), vector.z()};
}

void Sdins::step(const Increments& increments, std::optional<double> reference_height_m) {
  const double dt = increments.dt;
  if (!(dt > 0)) return;
  frame::Position& at = state_.position;

  // Rates and gravity are taken in the middle of the step.
  const Vector3d v_mid = state_.velocity_ned + dt / 2 * acceleration_;
  const double height_mid = at.height_m - dt / 2 * v_mid.z();
  const frame::LocalEarth earth = frame::local_earth(
      at.latitude_rad + dt / 2 * v_mid.x() / (frame::wgs84::semi_major_axis_m + height_mid),
      height_mid);
  const double north_arc = 1 / (earth.meridian_radius_m + height_mid);
  const double east_arc = 1 / (earth.transverse_radius_m + height_mid);
  const Vector3d earth_rate{earth.rate_north, 0, earth.rate_down};
  const Vector3d transport_rate{v_mid.y() * east_arc, -v_mid.x() * north_arc,
                                -v_mid.y() * east_arc * earth.tan_latitude};
  const Vector3d frame_turn = (earth_rate + transport_rate) * dt;

  // Eq. (N6): the specific force in the navigation axes at the middle of the step.
  Vector3d gained = state_.body_to_ned * increments.velocity;
  gained -= 0.5 * frame_turn.cross(gained);
  force_ned_ = gained / dt;
  acceleration_ = force_ned_ - (2 * earth_rate + transport_rate).cross(v_mid);
  acceleration_.z() += earth.gravity_mps2;

  // Eq. (N5).
  double climb_correction = 0;
  if (reference_height_m) {
    const double excess = height_mid - *reference_height_m;
    loop_acceleration_ += loop_.k3 * excess * dt;
    acceleration_.z() += loop_.k2 * excess;
    climb_correction = -loop_.k1 * excess;
  }
  acceleration_.z() += loop_acceleration_;

  const Vector3d v_end = state_.velocity_ned + dt * acceleration_;
  const Vector3d travelled = dt / 2 * (state_.velocity_ned + v_end);
  at.latitude_rad += travelled.x() * north_arc;
  at.longitude_rad += travelled.y() * east_arc / earth.cos_latitude;
  if (std::abs(at.longitude_rad) > std::numbers::pi)
    at.longitude_rad -= std::copysign(2 * std::numbers::pi, at.longitude_rad);
  at.height_m += climb_correction * dt - travelled.z();
  state_.velocity_ned = v_end;
  state_.body_to_ned = quaternion_of(-frame_turn) * state_.body_to_ned *  //
                       quaternion_of(increments.rotation);
  state_.body_to_ned.normalize();
}

void Sdins::correct(const Vector3d& position, const Vector3d& velocity, const Vector3d& phi) {
  state_.position.latitude_rad -= position.x();
  state_.position.longitude_rad -= position.y();
  state_.position.height_m -= position.z();
  state_.velocity_ned -= velocity;
  state_.body_to_ned = quaternion_of(phi) * state_.body_to_ned;
  state_.body_to_ned.normalize();
}

}  // namespace drydock::navigation
