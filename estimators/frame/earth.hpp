#pragma once

#include <Eigen/Core>

/// The Earth of WGS-84 (NIMA TR8350.2, third edition): ellipsoid, rotation, gravity.
/// Latitudes are geodetic, radians; heights are above the ellipsoid, metres, up.
namespace drydock::frame {

namespace wgs84 {
inline constexpr double semi_major_axis_m = 6378137.0;
inline constexpr double flattening = 1 / 298.257223563;
inline constexpr double semi_minor_axis_m = semi_major_axis_m * (1 - flattening);
inline constexpr double eccentricity_squared = flattening * (2 - flattening);
inline constexpr double earth_rate_radps = 7.292115e-5;
inline constexpr double gravitational_m3ps2 = 3.986004418e14;
inline constexpr double gravity_equator_mps2 = 9.7803253359;
inline constexpr double gravity_pole_mps2 = 9.8321849378;
}  // namespace wgs84

/// R_N: radius of curvature along the meridian (north-south), m.
double meridian_radius(double latitude_rad);

/// R_E: radius of curvature of the prime vertical (east-west), m.
double transverse_radius(double latitude_rad);

/// Rotation of the Earth against inertial space in NED, rad/s.
Eigen::Vector3d earth_rate_ned(double latitude_rad);

/// Rotation of the NED frame against the Earth at the velocity `velocity_ned`, in NED, rad/s.
/// Not defined at the poles.
Eigen::Vector3d transport_rate_ned(double latitude_rad, double height_m,
                                   const Eigen::Vector3d& velocity_ned);

/// Normal gravity (attraction and centrifugal acceleration), m/s2, along the normal of the
/// ellipsoid. Somigliana's closed form on the ellipsoid, a second-order Taylor series in height.
double gravity(double latitude_rad, double height_m = 0);

}  // namespace drydock::frame
