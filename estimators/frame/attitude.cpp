#include "estimators/frame/attitude.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace drydock::frame {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

Matrix3d ned_to_body(const Euler& attitude) {
  const double sr = std::sin(attitude.roll), cr = std::cos(attitude.roll);
  const double sp = std::sin(attitude.pitch), cp = std::cos(attitude.pitch);
  const double sy = std::sin(attitude.yaw), cy = std::cos(attitude.yaw);
  Matrix3d c;
  c << cp * cy, cp * sy, -sp,                                   //
      sr * sp * cy - cr * sy, sr * sp * sy + cr * cy, sr * cp,  //
      cr * sp * cy + sr * sy, cr * sp * sy - sr * cy, cr * cp;
  return c;
}

Quaterniond body_to_ned(const Euler& attitude) {
  const double sr = std::sin(attitude.roll / 2), cr = std::cos(attitude.roll / 2);
  const double sp = std::sin(attitude.pitch / 2), cp = std::cos(attitude.pitch / 2);
  const double sy = std::sin(attitude.yaw / 2), cy = std::cos(attitude.yaw / 2);
  Quaterniond q{cy * cp * cr + sy * sp * sr, cy * cp * sr - sy * sp * cr,
                cy * sp * cr + sy * cp * sr, sy * cp * cr - cy * sp * sr};
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  return q;
}

Euler euler(const Quaterniond& body_to_ned) {
  return euler(Matrix3d{body_to_ned.toRotationMatrix().transpose()});
}

Euler euler(const Matrix3d& c) {
  // Below this cosine of pitch, rounding decides how the rotation splits into roll and yaw.
  constexpr double vertical = 1e-9;
  const double cos_pitch = std::hypot(c(1, 2), c(2, 2));
  const double pitch = std::atan2(-c(0, 2), cos_pitch);
  if (cos_pitch < vertical) return {0, pitch, std::atan2(-c(1, 0), c(1, 1))};
  return {std::atan2(c(1, 2), c(2, 2)), pitch, std::atan2(c(0, 1), c(0, 0))};
}

Vector3d euler_rates(const Euler& attitude, const Vector3d& rate_nb_body) {
  const double sr = std::sin(attitude.roll), cr = std::cos(attitude.roll);
  const double across = rate_nb_body.y() * sr + rate_nb_body.z() * cr;
  return {rate_nb_body.x() + across * std::tan(attitude.pitch),
          rate_nb_body.y() * cr - rate_nb_body.z() * sr, across / std::cos(attitude.pitch)};
}

Vector3d body_rate(const Euler& attitude, const Vector3d& rates) {
  const double sr = std::sin(attitude.roll), cr = std::cos(attitude.roll);
  const double sp = std::sin(attitude.pitch), cp = std::cos(attitude.pitch);
  return {rates.x() - rates.z() * sp, rates.y() * cr + rates.z() * sr * cp,
          -rates.y() * sr + rates.z() * cr * cp};
}

Matrix3d skew(const Vector3d& a) {
  Matrix3d m;
  m << 0, -a.z(), a.y(),  //
      a.z(), 0, -a.x(),   //
      -a.y(), a.x(), 0;
  return m;
}

double wrap_pi(double angle) {
  const double wrapped = std::remainder(angle, 2 * std::numbers::pi);
  return wrapped <= -std::numbers::pi ? std::numbers::pi : wrapped;
}

}  // namespace drydock::frame
