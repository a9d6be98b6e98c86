#pragma once

namespace drydock::frame {

/// The Earth of earth.hpp at one place, everything that a navigation step needs at the price of one
/// sine and cosine, with the derivatives that its error model needs.
struct LocalEarth {
  double sin_latitude, cos_latitude, tan_latitude;
  double meridian_radius_m, transverse_radius_m;  ///< R_N, R_E
  double meridian_slope_m, transverse_slope_m;    ///< their derivatives by latitude, m/rad
  double rate_north, rate_down;                   ///< rotation of the Earth in NED, rad/s
  double gravity_mps2;
  double gravity_by_latitude;  ///< m/s2 per rad
  double gravity_by_height;    ///< m/s2 per m
};

LocalEarth local_earth(double latitude_rad, double height_m);

}  // namespace drydock::frame
