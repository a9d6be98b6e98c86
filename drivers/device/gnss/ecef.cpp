#include "drivers/device/gnss/ecef.hpp"

#include <cmath>

namespace drydock::device {

namespace {
constexpr double semi_major_m = 6'378'137.0, flattening = 1 / 298.257223563;
constexpr double eccentricity_squared = flattening * (2 - flattening);
}  // namespace

EllipsoidalPosition from_ecef(const Eigen::Vector3d& position_m) {
  const double from_axis_m = std::hypot(position_m.x(), position_m.y());
  // Fixed point of tan(latitude) = (z + e2 N sin(latitude)) / p. Each iteration reduces the error
  // by a factor of about e2 h/N.
  double latitude = std::atan2(position_m.z(), from_axis_m * (1 - eccentricity_squared));
  double normal_m = semi_major_m;
  for (int turn = 0; turn < 6; ++turn) {
    const double sine = std::sin(latitude);
    normal_m = semi_major_m / std::sqrt(1 - eccentricity_squared * sine * sine);
    latitude = std::atan2(position_m.z() + eccentricity_squared * normal_m * sine, from_axis_m);
  }
  const double sine = std::sin(latitude);
  EllipsoidalPosition result;
  result.horizontal = {latitude, std::atan2(position_m.y(), position_m.x())};
  result.height_m = from_axis_m * std::cos(latitude) + position_m.z() * sine -
                    normal_m * (1 - eccentricity_squared * sine * sine);
  return result;
}

Eigen::Vector3d to_ecef(const EllipsoidalPosition& position) {
  const auto [latitude, longitude] = position.horizontal;
  const double sine = std::sin(latitude);
  const double normal_m = semi_major_m / std::sqrt(1 - eccentricity_squared * sine * sine);
  const double from_axis_m = (normal_m + position.height_m) * std::cos(latitude);
  return {from_axis_m * std::cos(longitude), from_axis_m * std::sin(longitude),
          (normal_m * (1 - eccentricity_squared) + position.height_m) * sine};
}

Eigen::Vector3d ned_of_ecef(const Eigen::Vector3d& vector, const measurement::Geodetic& at) {
  const double sin_lat = std::sin(at.latitude_rad), cos_lat = std::cos(at.latitude_rad);
  const double sin_lon = std::sin(at.longitude_rad), cos_lon = std::cos(at.longitude_rad);
  const double outward = cos_lon * vector.x() + sin_lon * vector.y();
  return {cos_lat * vector.z() - sin_lat * outward, cos_lon * vector.y() - sin_lon * vector.x(),
          -cos_lat * outward - sin_lat * vector.z()};
}

Eigen::Vector3d ecef_of_ned(const Eigen::Vector3d& vector, const measurement::Geodetic& at) {
  const double sin_lat = std::sin(at.latitude_rad), cos_lat = std::cos(at.latitude_rad);
  const double sin_lon = std::sin(at.longitude_rad), cos_lon = std::cos(at.longitude_rad);
  const double outward = -sin_lat * vector.x() - cos_lat * vector.z();
  return {cos_lon * outward - sin_lon * vector.y(), sin_lon * outward + cos_lon * vector.y(),
          cos_lat * vector.x() - sin_lat * vector.z()};
}

}  // namespace drydock::device
