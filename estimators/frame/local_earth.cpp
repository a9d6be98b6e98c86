#include "estimators/frame/local_earth.hpp"

#include <cmath>

#include "estimators/frame/earth.hpp"

namespace drydock::frame {

using namespace wgs84;

LocalEarth local_earth(double latitude_rad, double height_m) {
  LocalEarth at{};
  const double s = std::sin(latitude_rad), c = std::cos(latitude_rad), s2 = s * s;
  at.sin_latitude = s;
  at.cos_latitude = c;
  at.tan_latitude = s / c;

  const double w = 1 - eccentricity_squared * s2, root = std::sqrt(w);
  const double w_slope = eccentricity_squared * s * c / w;  // -dw/dlatitude / 2w
  at.transverse_radius_m = semi_major_axis_m / root;
  at.meridian_radius_m = at.transverse_radius_m * (1 - eccentricity_squared) / w;
  at.transverse_slope_m = at.transverse_radius_m * w_slope;
  at.meridian_slope_m = 3 * at.meridian_radius_m * w_slope;
  at.rate_north = earth_rate_radps * c;
  at.rate_down = -earth_rate_radps * s;

  // TR8350.2 eq. 4-1 and 4-3, as in gravity(), and their derivatives by s2 and height.
  constexpr double k =
      semi_minor_axis_m * gravity_pole_mps2 / (semi_major_axis_m * gravity_equator_mps2) - 1;
  constexpr double m = earth_rate_radps * earth_rate_radps * semi_major_axis_m * semi_major_axis_m *
                       semi_minor_axis_m / gravitational_m3ps2;
  const double h = height_m / semi_major_axis_m;
  const double on_ellipsoid = gravity_equator_mps2 * (1 + k * s2) / root;
  const double slope = 2 * (1 + flattening + m - 2 * flattening * s2);
  const double in_height = 1 - slope * h + 3 * h * h;
  at.gravity_mps2 = on_ellipsoid * in_height;
  at.gravity_by_height = on_ellipsoid * (6 * h - slope) / semi_major_axis_m;
  at.gravity_by_latitude =
      2 * s * c *
          (gravity_equator_mps2 * k / root * in_height + on_ellipsoid * 4 * flattening * h) +
      on_ellipsoid * w_slope * in_height;
  return at;
}

}  // namespace drydock::frame
