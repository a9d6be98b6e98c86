#include "estimators/frame/geodetic.hpp"

#include <cmath>

#include "estimators/frame/earth.hpp"

namespace drydock::frame {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d ecef(const Position& position) {
  const double s = std::sin(position.latitude_rad), c = std::cos(position.latitude_rad);
  const double n = transverse_radius(position.latitude_rad);
  const double from_axis = (n + position.height_m) * c;
  return {from_axis * std::cos(position.longitude_rad),
          from_axis * std::sin(position.longitude_rad),
          (n * (1 - wgs84::eccentricity_squared) + position.height_m) * s};
}

Position geodetic(const Vector3d& ecef) {
  constexpr double a = wgs84::semi_major_axis_m, b = wgs84::semi_minor_axis_m;
  constexpr double e2 = wgs84::eccentricity_squared, second_e2 = e2 / (1 - e2);
  const double from_axis = std::hypot(ecef.x(), ecef.y()), z = ecef.z();
  double latitude = 0;
  // Bowring: the reduced latitude gives the latitude, and the latitude gives a better reduced
  // latitude. Each turn gains about three digits near the Earth and more at a greater height. After
  // four turns only rounding is left.
  double sin_reduced = z * a, cos_reduced = from_axis * b;
  for (int turn = 0; turn < 4; ++turn) {
    const double norm = std::hypot(sin_reduced, cos_reduced);
    const double s = sin_reduced / norm, c = cos_reduced / norm;
    latitude = std::atan2(z + second_e2 * b * s * s * s, from_axis - e2 * a * c * c * c);
    sin_reduced = b * std::sin(latitude);
    cos_reduced = a * std::cos(latitude);
  }
  const double s = std::sin(latitude), c = std::cos(latitude);
  // The projection on the normal is accurate both at the equator and at the poles.
  const double height = from_axis * c + z * s - a * std::sqrt(1 - e2 * s * s);
  return {latitude, std::atan2(ecef.y(), ecef.x()), height};
}

Matrix3d ecef_to_ned(double latitude_rad, double longitude_rad) {
  const double sb = std::sin(latitude_rad), cb = std::cos(latitude_rad);
  const double sl = std::sin(longitude_rad), cl = std::cos(longitude_rad);
  Matrix3d c;
  c << -sb * cl, -sb * sl, cb,  //
      -sl, cl, 0,               //
      -cb * cl, -cb * sl, -sb;
  return c;
}

Vector3d ned_offset(const Position& origin, const Position& point) {
  return ecef_to_ned(origin.latitude_rad, origin.longitude_rad) * (ecef(point) - ecef(origin));
}

Position at_ned_offset(const Position& origin, const Vector3d& offset) {
  const Matrix3d to_ecef = ecef_to_ned(origin.latitude_rad, origin.longitude_rad).transpose();
  return geodetic(ecef(origin) + to_ecef * offset);
}

}  // namespace drydock::frame
