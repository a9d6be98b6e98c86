#pragma once

#include <Eigen/Core>

#include "drivers/measurement/measurement.hpp"

/// Earth-centred axes, in which receivers before NAV-PVT say position and velocity, and the WGS-84
/// ellipsoid.
namespace drydock::device {

struct EllipsoidalPosition {
  measurement::Geodetic horizontal;
  double height_m = 0;
};

/// Below 1e-9 m of error within 10 km of the surface.
EllipsoidalPosition from_ecef(const Eigen::Vector3d& position_m);

Eigen::Vector3d to_ecef(const EllipsoidalPosition& position);

/// Turns a vector from Earth-centred axes to north, east, down at a place.
Eigen::Vector3d ned_of_ecef(const Eigen::Vector3d& vector, const measurement::Geodetic& at);

/// And back.
Eigen::Vector3d ecef_of_ned(const Eigen::Vector3d& vector, const measurement::Geodetic& at);

}  // namespace drydock::device
