#include "estimators/frame/earth.hpp"

#include <cmath>

namespace drydock::frame {

using Eigen::Vector3d;

namespace {

/// 1 - e2 sin2(latitude)
double curvature_term(double latitude_rad) {
  const double s = std::sin(latitude_rad);
  return 1 - wgs84::eccentricity_squared * s * s;
}

}  // namespace

double meridian_radius(double latitude_rad) {
  const double w = curvature_term(latitude_rad);
  return wgs84::semi_major_axis_m * (1 - wgs84::eccentricity_squared) / (w * std::sqrt(w));
}

double transverse_radius(double latitude_rad) {
  return wgs84::semi_major_axis_m / std::sqrt(curvature_term(latitude_rad));
}

Vector3d earth_rate_ned(double latitude_rad) {
  return wgs84::earth_rate_radps * Vector3d{std::cos(latitude_rad), 0, -std::sin(latitude_rad)};
}

Vector3d transport_rate_ned(double latitude_rad, double height_m, const Vector3d& velocity_ned) {
  const double east = velocity_ned.y() / (transverse_radius(latitude_rad) + height_m);
  const double north = velocity_ned.x() / (meridian_radius(latitude_rad) + height_m);
  return {east, -north, -east * std::tan(latitude_rad)};
}

double gravity(double latitude_rad, double height_m) {
  using namespace wgs84;
  const double s2 = std::pow(std::sin(latitude_rad), 2);
  // TR8350.2 eq. 4-1
  constexpr double k =
      semi_minor_axis_m * gravity_pole_mps2 / (semi_major_axis_m * gravity_equator_mps2) - 1;
  const double on_ellipsoid =
      gravity_equator_mps2 * (1 + k * s2) / std::sqrt(1 - eccentricity_squared * s2);
  // TR8350.2 eq. 4-3
  constexpr double m = earth_rate_radps * earth_rate_radps * semi_major_axis_m * semi_major_axis_m *
                       semi_minor_axis_m / gravitational_m3ps2;
  const double h = height_m / semi_major_axis_m;
  return on_ellipsoid * (1 - 2 * (1 + flattening + m - 2 * flattening * s2) * h + 3 * h * h);
}

}  // namespace drydock::frame
