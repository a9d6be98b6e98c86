#pragma once

#include <Eigen/Core>

#include "estimators/frame/geodetic.hpp"
#include "hil/sky/ephemeris.hpp"

namespace drydock::sky {

/// A satellite as seen from a place.
struct Look {
  double elevation_rad = 0;    ///< above the ellipsoid's horizon
  double azimuth_rad = 0;      ///< [0, 2 pi), from north over east
  double range_m = 0;          ///< geometric, from emission to reception
  Eigen::Vector3d toward_ned;  ///< unit vector to the satellite in the place's NED axes
};

/// At a reception time: the satellite stands where it was when the signal left, and the Earth has
/// turned under the signal since (docs/world/sky.md eq. (11), (12)). The atmosphere does not bend
/// it.
Look look_at(const Ephemeris& record, GpsTime reception, const frame::Position& place);

}  // namespace drydock::sky
