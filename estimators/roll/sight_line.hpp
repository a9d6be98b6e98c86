#pragma once

#include <Eigen/Core>

/// Roll of a rolling airframe from the strength of satellite signals and a roll gyro. Source: Hong,
/// Kim, Ryoo and Lee, "Roll Angle Estimation of a Rolling Airframe Using a GPS and a Roll Rate
/// Gyro", J. KSAS 43(2), 2015. Equation numbers are those of docs/estimators/roll.md.
namespace drydock::roll {

/// Direction of the x axis of the airframe. It is assumed to lie along the velocity.
struct FlightPath {
  double azimuth_rad = 0;  ///< from north over east
  double pitch_rad = 0;    ///< above the horizon
};

/// Eq. (9), corrected, with the course as azimuth. The velocity must not be zero.
FlightPath flight_path(const Eigen::Vector3d& velocity_ned);

/// Eq. (4), corrected: the azimuth, at a place, of the great circle to a point.
double azimuth_of_point(double latitude_rad, double longitude_rad, double point_latitude_rad,
                        double point_longitude_rad);

/// Unit vector to a satellite in NED axes.
Eigen::Vector3d toward_ned(double elevation_rad, double azimuth_rad);

/// The elevation of one satellite above the horizon plane of the antenna, as a function of the
/// roll: eq. (11), (12) and (24) combined, sin El = c_0 + c_1 cos(roll) + c_2 sin(roll).
class SightLine {
 public:
  /// Unit vectors; the paper has the boresight on body +z.
  SightLine(const Eigen::Vector3d& toward_ned, const FlightPath& path,
            const Eigen::Vector3d& boresight_body);

  double sin_elevation(double roll_rad) const;
  double slope(double roll_rad) const;  ///< d sin_elevation / d roll

  /// Eq. (17): the roll with the largest elevation of the satellite, (-pi, pi].
  double strongest_roll() const;

 private:
  double c0_, c1_, c2_;
};

}  // namespace drydock::roll
