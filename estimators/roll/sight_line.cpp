#include "estimators/roll/sight_line.hpp"

#include <cmath>

#include "estimators/frame/attitude.hpp"

namespace drydock::roll {

using Eigen::Vector3d;

FlightPath flight_path(const Vector3d& velocity_ned) {
  return {std::atan2(velocity_ned.y(), velocity_ned.x()),
          std::atan2(-velocity_ned.z(), velocity_ned.head<2>().norm())};
}

double azimuth_of_point(double latitude_rad, double longitude_rad, double point_latitude_rad,
                        double point_longitude_rad) {
  const double across = point_longitude_rad - longitude_rad;
  return std::atan2(std::sin(across) * std::cos(point_latitude_rad),
                    std::cos(latitude_rad) * std::sin(point_latitude_rad) -
                        std::sin(latitude_rad) * std::cos(point_latitude_rad) * std::cos(across));
}

Vector3d toward_ned(double elevation_rad, double azimuth_rad) {
  return {std::cos(elevation_rad) * std::cos(azimuth_rad),
          std::cos(elevation_rad) * std::sin(azimuth_rad), -std::sin(elevation_rad)};
}

SightLine::SightLine(const Vector3d& toward_ned, const FlightPath& path,
                     const Vector3d& boresight_body) {
  const Vector3d p =
      frame::ned_to_body({0, path.pitch_rad, path.azimuth_rad}) * toward_ned;  // (11)
  const Vector3d& a = boresight_body;
  c0_ = a.x() * p.x();
  c1_ = a.y() * p.y() + a.z() * p.z();
  c2_ = a.y() * p.z() - a.z() * p.y();
}

double SightLine::sin_elevation(double roll_rad) const {
  return c0_ + c1_ * std::cos(roll_rad) + c2_ * std::sin(roll_rad);
}

double SightLine::slope(double roll_rad) const {
  return c2_ * std::cos(roll_rad) - c1_ * std::sin(roll_rad);
}

double SightLine::strongest_roll() const { return std::atan2(c2_, c1_); }

}  // namespace drydock::roll
