#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>

#include "estimators/hydrodynamics/model.hpp"
#include "hil/motion/vehicle/actuators.hpp"
#include "hil/ocean/ocean.hpp"
#include "rig_config/mission.hpp"

/// An underwater vehicle on the rotating WGS-84 Earth, in water that moves over ground. Equation
/// numbers are those of docs/world/vehicle.md.
namespace drydock::motion {

/// The place and motion of a vehicle at one instant.
struct VehicleState {
  double latitude_rad = 0, longitude_rad = 0, height_m = 0;
  Eigen::Quaterniond body_to_ned = Eigen::Quaterniond::Identity();
  hydrodynamics::Velocity velocity = hydrodynamics::Velocity::Zero();  ///< through the water
};

/// The time derivative of a state.
struct VehicleRate {
  Eigen::Vector3d velocity_ned;      ///< over ground, m/s: eq. (1)
  Eigen::Vector4d attitude;          ///< quaternion x y z w: eq. (3)
  hydrodynamics::Velocity velocity;  ///< u v w p q r: eq. (4)
};

/// What a vehicle does at the surface and at the bed.
enum class Edges : std::uint8_t {
  open,   ///< nothing: its plan stays in the water
  closed  ///< it cannot leave the water, sink into the bed, or leave its equations
};

/// dV^n/dt of eq. (5), from which an accelerometer's reading follows, m/s2. `t_s` counts from the
/// mission's start.
Eigen::Vector3d acceleration_ned(const VehicleState& state, const VehicleRate& rate,
                                 const ocean::Ocean& ocean, double t_s);

/// The equations of one vehicle in one sea.
class VehicleMotion {
 public:
  /// `mission.vehicle` must be set. Throws std::invalid_argument, see hydrodynamics::Model and
  /// ocean::Ocean.
  VehicleMotion(const rig_config::MissionConfig& mission, Edges edges);

  VehicleRate rate(const VehicleState& state, const hydrodynamics::Control& control,
                   double t) const;

  /// The state h seconds after t by Runge-Kutta 4. `rate` is the rate at t. The actuators move on
  /// with a held command. The result is a smooth function of h up to the step of the truth.
  VehicleState step(const VehicleState& state, const VehicleRate& rate, Actuators& actuators,
                    const Command& command, double t, double h) const;

  const ocean::Ocean& ocean() const { return ocean_; }

 private:
  struct Earth;

  VehicleRate rate(const VehicleState& state, const hydrodynamics::Control& control, double t,
                   const Earth& earth) const;

  std::optional<hydrodynamics::Model> model_;  ///< empty: a kinematic vehicle
  ocean::Ocean ocean_;
  Edges edges_;
};

}  // namespace drydock::motion
