#pragma once

#include <Eigen/Core>

#include "drivers/measurement/units.hpp"
#include "estimators/frame/attitude.hpp"

namespace drydock::study {

/// The sensor readings of the leveling study over one interval of `dt`: specific force (m/s2) and
/// rate (rad/s) in its middle, in body axes, and the speed ahead through the water at its end.
struct LevelingReading {
  Eigen::Vector3d specific_force, angular_rate;
  double speed_mps;
};

/// Truth in closed form: heading, roll and pitch are sines, and the vehicle slips in turns. Angles
/// in rad, periods in s.
struct LevelingMotion {
  double speed_mps = 10, surge_mps = 0;  ///< speed ahead: speed + surge sin(2 pi t / yaw_period)
  double yaw = 0, yaw_period = 30;       ///< amplitude; 0: straight
  double roll = 0, roll_period = 6;
  double pitch = 0, pitch_period = 9;
  double slip_m = 0;  ///< sideways speed = -slip times the rate of heading

  frame::Euler attitude(double t) const;
  Eigen::Vector3d euler_rates(double t) const;   ///< roll, pitch, yaw
  Eigen::Vector3d velocity(double t) const;      ///< body axes, m/s
  Eigen::Vector3d acceleration(double t) const;  ///< time derivative of the components of
                                                 ///< `velocity`, m/s2

  /// Perfect sensors over [t, t + dt] on the rotating Earth, by the paper's eq. (12)-(17).
  LevelingReading reading(double t, double dt, double latitude_rad) const;
};

/// The paper's three motions and an additional one. The S path is our choice, because the paper's
/// figure of it is lost.
namespace leveling_motions {
inline constexpr LevelingMotion stationary{.speed_mps = 0};
inline constexpr LevelingMotion straight{};
inline constexpr LevelingMotion s_path{.yaw = 45 * units::degree};
inline constexpr LevelingMotion rolling_s_path{.surge_mps = 2,
                                               .yaw = 45 * units::degree,
                                               .roll = 10 * units::degree,
                                               .pitch = 5 * units::degree,
                                               .slip_m = 2.5};
}  // namespace leveling_motions

}  // namespace drydock::study
