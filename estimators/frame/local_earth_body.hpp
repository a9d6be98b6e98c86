#pragma once

#include "estimators/frame/earth.hpp"
#include "estimators/frame/local_earth.hpp"
#include "estimators/lanes/real.hpp"

namespace drydock::frame {

template <class Real>
BasicLocalEarth<Real> local_earth(const Real& latitude_rad, const Real& height_m) {
  using namespace wgs84;
  using lanes::cos, lanes::sin, lanes::sqrt;
  BasicLocalEarth<Real> at{};
  const Real s = sin(latitude_rad), c = cos(latitude_rad), s2 = s * s;
  at.sin_latitude = s;
  at.cos_latitude = c;
  at.tan_latitude = s / c;

  const Real w = 1 - eccentricity_squared * s2, root = sqrt(w);
  const Real w_slope = eccentricity_squared * s * c / w;  // -dw/dlatitude / 2w
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
  const Real h = height_m / semi_major_axis_m;
  const Real on_ellipsoid = gravity_equator_mps2 * (1 + k * s2) / root;
  const Real slope = 2 * (1 + flattening + m - 2 * flattening * s2);
  const Real in_height = 1 - slope * h + 3 * h * h;
  at.gravity_mps2 = on_ellipsoid * in_height;
  at.gravity_by_height = on_ellipsoid * (6 * h - slope) / semi_major_axis_m;
  at.gravity_by_latitude =
      2 * s * c *
          (gravity_equator_mps2 * k / root * in_height + on_ellipsoid * 4 * flattening * h) +
      on_ellipsoid * w_slope * in_height;
  return at;
}

}  // namespace drydock::frame
