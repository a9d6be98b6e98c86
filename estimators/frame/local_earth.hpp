#pragma once

namespace drydock::frame {

/// The Earth of earth.hpp at one place. It holds all values that a navigation step and its error
/// model need, and costs one sine and one cosine.
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
