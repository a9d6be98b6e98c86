#pragma once

#include <Eigen/Geometry>
#include <boost/container/static_vector.hpp>
#include <optional>

#include "drivers/measurement/stamp.hpp"
#include "hil/ocean/ocean.hpp"

namespace drydock::motion {

using measurement::Stamp;

inline constexpr std::size_t most_thrusters = 32;  ///< of a vehicle file

/// The truth from which every emulated sensor is derived. Body FRD, navigation NED, SI.
struct Truth {
  Stamp at{};
  double latitude_rad = 0, longitude_rad = 0;  ///< WGS-84
  double height_m = 0;                         ///< above the ellipsoid, up; depth = -height
  double roll_rad = 0, pitch_rad = 0, yaw_rad = 0;
  Eigen::Quaterniond body_to_ned = Eigen::Quaterniond::Identity();
  Eigen::Vector3d velocity_body = Eigen::Vector3d::Zero();   ///< m/s, over ground
  Eigen::Vector3d velocity_ned = Eigen::Vector3d::Zero();    ///< m/s
  Eigen::Vector3d specific_force = Eigen::Vector3d::Zero();  ///< m/s2, body
  Eigen::Vector3d angular_rate = Eigen::Vector3d::Zero();    ///< rad/s, body against inertial
  std::optional<Eigen::Vector3d> angular_acceleration;       ///< if known, rad/s2
  Eigen::Vector3d rate_body = Eigen::Vector3d::Zero();       ///< rad/s, body against NED (p, q, r)
  Eigen::Vector3d current_ned = Eigen::Vector3d::Zero();     ///< m/s, of the water at the vehicle
  double bed_depth_m = 0;                                    ///< the sea bed under the vehicle
  double rudder_rad = 0, stern_plane_rad = 0, bow_plane_rad = 0, propeller_radps = 0;
  /// Of each thruster of the vehicle file. Empty: the vehicle has none, or the file no limit_rpm.
  boost::container::static_vector<double, most_thrusters> thruster_radps;
};

/// A motion that can be evaluated at any time of the mission, in any order, with the same result.
class Trajectory {
 public:
  virtual ~Trajectory() = default;
  virtual Truth at(Stamp time) const = 0;
  virtual Stamp start() const = 0;
  virtual Stamp end() const = 0;

  /// The water of the motion; its times count from start(). By default it is still and 100 m deep.
  virtual const ocean::Ocean& ocean() const;
};

}  // namespace drydock::motion
