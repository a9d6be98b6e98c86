#pragma once

#include <Eigen/Geometry>

#include "estimators/hydrodynamics/vehicle.hpp"
#include "rig_config/thruster_vehicle.hpp"

namespace drydock::motion {

/// The equations of motion of a vehicle with thrusters (Fossen, Handbook of Marine Craft
/// Hydrodynamics and Motion Control, 2011, eq. 7.190 in still water):
///   M dv/dt + C(v) v + D(v) v + g = tau
/// with constant added mass and with linear and quadratic damping along and about each axis. C is
/// that of the rigid body: the moment that potential flow gives to a moving body would turn an open
/// frame across its way, which it does not do.
class ThrusterHull {
 public:
  explicit ThrusterHull(const rig_config::ThrusterVehicleConfig& config);

  /// d/dt of u v w p q r. `velocity` is through the water, `wrench` that of the thrusters. At a
  /// height above the surface the hull loses buoyancy.
  hydrodynamics::Velocity acceleration(const hydrodynamics::Velocity& velocity,
                                       const Eigen::Matrix3d& body_to_ned, double height_m,
                                       const hydrodynamics::Wrench& wrench) const;

  static constexpr double hull_height_m = 0.25;  ///< above the water it has no buoyancy left

 private:
  hydrodynamics::Wrench hydrostatics(const Eigen::Vector3d& down, double height_m) const;

  rig_config::ThrusterVehicleConfig config_;
  hydrodynamics::Matrix6 mass_;          ///< of the rigid body
  hydrodynamics::Matrix6 inverse_mass_;  ///< with the added mass
  hydrodynamics::Velocity linear_, quadratic_;
};

}  // namespace drydock::motion
