#pragma once

#include <Eigen/Core>

namespace drydock::frame {

/// The Earth of earth.hpp at one place. It holds all values that a navigation step and its error
/// model need, and costs one sine and one cosine.
template <class Real>
struct BasicLocalEarth {
  Real sin_latitude, cos_latitude, tan_latitude;
  Real meridian_radius_m, transverse_radius_m;  ///< R_N, R_E
  Real meridian_slope_m, transverse_slope_m;    ///< their derivatives by latitude, m/rad
  Real rate_north, rate_down;                   ///< rotation of the Earth in NED, rad/s
  Real gravity_mps2;
  Real gravity_by_latitude;  ///< m/s2 per rad
  Real gravity_by_height;    ///< m/s2 per m

  Eigen::Vector3<Real> earth_rate_ned() const { return {rate_north, 0, rate_down}; }
};
using LocalEarth = BasicLocalEarth<double>;

LocalEarth local_earth(double latitude_rad, double height_m);

/// The same of several places; local_earth_body.hpp has it.
template <class Real>
BasicLocalEarth<Real> local_earth(const Real& latitude_rad, const Real& height_m);

}  // namespace drydock::frame
