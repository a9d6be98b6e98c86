#pragma once

#include <Eigen/Core>

/// Positions on WGS-84: latitude, longitude, height <-> ECEF <-> local north, east, down.
namespace drydock::frame {

struct Position {
  double latitude_rad = 0, longitude_rad = 0;
  double height_m = 0;  ///< above the ellipsoid, up
};

/// Earth-centred Earth-fixed coordinates, m.
Eigen::Vector3d ecef(const Position& position);

/// The inverse: Bowring's formula, iterated until it converges. The error is below 1e-9 m from the
/// Earth's crust up to satellite orbits. On the polar axis the longitude is 0.
Position geodetic(const Eigen::Vector3d& ecef);

/// Converts the coordinates of a vector from ECEF to the NED axes of a place.
Eigen::Matrix3d ecef_to_ned(double latitude_rad, double longitude_rad);

/// The straight line from `origin` to `point`, in the NED axes of `origin`, m.
Eigen::Vector3d ned_offset(const Position& origin, const Position& point);

/// The point that lies at `offset` in the NED axes of `origin`.
Position at_ned_offset(const Position& origin, const Eigen::Vector3d& offset);

}  // namespace drydock::frame
