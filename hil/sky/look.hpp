#pragma once

#include <Eigen/Core>

#include "estimators/frame/geodetic.hpp"
#include "hil/sky/ephemeris.hpp"

namespace drydock::sky {

/// The direction and distance of a satellite from a place.
struct Look {
  double elevation_rad = 0;    ///< above the ellipsoid's horizon
  double azimuth_rad = 0;      ///< [0, 2 pi), from north through east
  double range_m = 0;          ///< geometric, from emission to reception
  Eigen::Vector3d toward_ned;  ///< unit vector to the satellite in the place's NED axes
};

/// For a reception time. The satellite position is that of the emission time, and the Earth rotates
/// during the signal's flight (docs/world/sky.md eq. (11), (12)). The atmosphere is not modelled.
Look look_at(const Ephemeris& record, GpsTime reception, const frame::Position& place);

}  // namespace drydock::sky
