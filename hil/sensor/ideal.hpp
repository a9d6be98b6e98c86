#pragma once

#include "drivers/measurement/measurement.hpp"
#include "estimators/frame/geodetic.hpp"
#include "hil/motion/truth.hpp"
#include "hil/sensor/mounting.hpp"

/// The output of a perfect sensor at its place in the vehicle. Vectors are in the sensor's own
/// axes; the driver turns them into the body frame. Origin holds valid_at only.
namespace drydock::sensor {

using motion::Stamp;
using motion::Trajectory;
using motion::Truth;

/// Specific force f + w x (w x r) + dw/dt x r and rate w, both against inertial space. dw/dt is
/// taken from the truth, or as its central difference over 2 ms if the truth has none. Gravity is
/// taken as equal at both ends of r.
measurement::ImuSample ideal_imu(const Trajectory& trajectory, Stamp at, const Mounting& mounting);

/// Over-ground velocity v + w x r of the sensor in its own axes. w is relative to NED; the rotation
/// of NED relative to the Earth adds less than 1e-6 m/s.
Eigen::Vector3d velocity_at(const Truth& truth, const Mounting& mounting);

/// Speed through the water along the log's x (longitudinal) and y (transverse) axes. The current is
/// taken at the log's depth. distance_m stays empty: the device that counts adds it.
measurement::WaterSpeed ideal_log(const Trajectory& trajectory, Stamp at, const Mounting& mounting);

/// An antenna below this depth receives nothing.
inline constexpr double antenna_awash_depth_m = 0.3;

/// Position, height and velocity of the antenna. The sea surface is the ellipsoid. Under water:
/// FixType::none and only the time.
measurement::GnssFix ideal_gnss(const Truth& truth, const Mounting& mounting);

/// Depth of the sensor and the ocean's pressure and temperature there.
measurement::DepthSample ideal_depth(const Truth& truth, const ocean::Ocean& ocean,
                                     const Mounting& mounting);

double depth_at(const Truth& truth, const Mounting& mounting);  ///< depth of the sensor, m
frame::Position place_of(const Truth& truth, const Mounting& mounting);
/// Height of the sensor above the bed directly below it, m.
double altitude_at(const Truth& truth, const ocean::Ocean& ocean, const Mounting& mounting);

measurement::ActuatorState ideal_actuators(const Truth& truth);

/// Turns of the propeller, or of the thruster with that number, which the truth must have, rad/s.
double ideal_shaft(const Truth& truth, int actuator);

/// True heading, roll and pitch of the sensor's own axes; the rate of the body's heading.
measurement::AttitudeSample ideal_attitude(const Truth& truth, const Mounting& mounting);

}  // namespace drydock::sensor
