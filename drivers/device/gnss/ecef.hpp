#pragma once

#include <Eigen/Core>

#include "drivers/measurement/measurement.hpp"

/// Earth-centred axes and the WGS-84 ellipsoid. Receivers without NAV-PVT give position and
/// velocity in these axes.
namespace drydock::device {

struct EllipsoidalPosition {
  measurement::Geodetic horizontal;
  double height_m = 0;
};

/// The error is below 1e-9 m within 10 km of the surface.
EllipsoidalPosition from_ecef(const Eigen::Vector3d& position_m);

Eigen::Vector3d to_ecef(const EllipsoidalPosition& position);

/// Converts a vector from Earth-centred axes to north, east, down at a place.
Eigen::Vector3d ned_of_ecef(const Eigen::Vector3d& vector, const measurement::Geodetic& at);

/// The reverse of ned_of_ecef.
Eigen::Vector3d ecef_of_ned(const Eigen::Vector3d& vector, const measurement::Geodetic& at);

}  // namespace drydock::device
