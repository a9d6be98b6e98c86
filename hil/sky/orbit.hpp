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
  Eigen::Vector3d ecef_m;   ///< antenna, in the ECEF frame of that same instant
  double clock_s = 0;       ///< the satellite's clock ahead of GPS time, relativity within
  double relativity_s = 0;  ///< the part of it that e F sqrt(A) sin E makes
};

/// Holds for records that `absurd` has nothing against; any time, though the broadcast fits only
/// some two hours around toe.
SatelliteState satellite_at(const Ephemeris& record, GpsTime time);

/// Why a record cannot be the orbit of a GPS satellite, whatever its health bits say: semi-major
/// axis, eccentricity, inclination or the radius at toe far from the constellation's (IS-GPS-200,
/// table 20-III; 26 560 km, 55 deg). Nothing for a sound one.
std::optional<std::string> absurd(const Ephemeris& record);

}  // namespace drydock::sky
