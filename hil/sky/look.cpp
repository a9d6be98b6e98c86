#include "hil/sky/look.hpp"

#include <cmath>
#include <numbers>

#include "hil/sky/orbit.hpp"

namespace drydock::sky {

Look look_at(const Ephemeris& record, GpsTime reception, const frame::Position& place) {
  const Eigen::Vector3d antenna = frame::ecef(place);
  Eigen::Vector3d line = Eigen::Vector3d::Zero();
  double flight_s = 0.075;
  // 0.075 s is wrong by less than 0.02 s; each iteration reduces the error by 1e-5 (speed over c).
  for (int turn = 0; turn < 3; ++turn) {
    const auto p = satellite_at(record, reception - measurement::from_seconds(flight_s)).ecef_m;
    const double turned = gps_earth_rate * flight_s, s = std::sin(turned), c = std::cos(turned);
    line = Eigen::Vector3d{c * p.x() + s * p.y(), c * p.y() - s * p.x(), p.z()} - antenna;
    flight_s = line.norm() / light_speed;
  }
  Look look;
  look.range_m = line.norm();
  look.toward_ned =
      frame::ecef_to_ned(place.latitude_rad, place.longitude_rad) * line / look.range_m;
  look.elevation_rad = std::atan2(-look.toward_ned.z(), look.toward_ned.head<2>().norm());
  const double azimuth = std::atan2(look.toward_ned.y(), look.toward_ned.x());
  look.azimuth_rad = azimuth < 0 ? azimuth + 2 * std::numbers::pi : azimuth;
  return look;
}

}  // namespace drydock::sky
