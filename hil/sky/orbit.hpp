#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "hil/sky/ephemeris.hpp"

/// The user's algorithm of IS-GPS-200 for a broadcast record: orbit 20.3.3.4.3.1 (table 20-IV),
/// clock 20.3.3.3.3.1. docs/world/sky.md numbers the equations.
namespace drydock::sky {

inline constexpr double gps_mu = 3.986005e14;               ///< m3/s2, eq. (1)
inline constexpr double gps_earth_rate = 7.2921151467e-5;   ///< rad/s, eq. (7)
inline constexpr double light_speed = 299792458;            ///< m/s
inline constexpr double gps_relativity = -4.442807633e-10;  ///< F, s/m^(1/2), eq. (9)

struct SatelliteState {
  Eigen::Vector3d ecef_m;   ///< antenna, in the ECEF frame of the same instant
  double clock_s = 0;       ///< satellite clock minus GPS time, with the relativistic part
  double relativity_s = 0;  ///< the relativistic part: F e sqrt(A) sin E
};

/// Valid for records that `absurd` accepts. Any time is allowed, but the broadcast is accurate only
/// within about two hours of toe.
SatelliteState satellite_at(const Ephemeris& record, GpsTime time);

/// Why a record cannot be the orbit of a GPS satellite, whatever its health bits say: the
/// semi-major axis, eccentricity, inclination or radius at toe is far from that of the
/// constellation (IS-GPS-200, table 20-III; 26 560 km, 55 deg). Empty for a sound record.
std::optional<std::string> absurd(const Ephemeris& record);

}  // namespace drydock::sky
