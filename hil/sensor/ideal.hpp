#pragma once

#include "drivers/measurement/measurement.hpp"
#include "hil/motion/truth.hpp"
#include "hil/sensor/mounting.hpp"

/// What a perfect sensor at its place in the vehicle would report of the truth. Vectors are in the
/// sensor's own axes: turning them into the body frame is the driver's work. Origin holds valid_at
/// only.
namespace drydock::sensor {

using motion::Stamp;
using motion::Trajectory;
using motion::Truth;

/// Specific force f + w x (w x r) + dw/dt x r and rate w, both against inertial space. dw/dt is the
/// central difference of the truth over 2 ms; gravity is taken as the same at both ends of r.
measurement::ImuSample ideal_imu(const Trajectory& trajectory, Stamp at, const Mounting& mounting);

/// Over-ground velocity v + w x r of the sensor in its own axes. w is against NED: the turn of NED
/// against the Earth adds less than 1e-6 m/s.
Eigen::Vector3d velocity_at(const Truth& truth, const Mounting& mounting);

/// Four Janus beams over a flat bed, in PD0's order for a head that looks down with beam 3 ahead:
/// port, starboard, forward, aft.
struct JanusBeams {
  double angle_rad = 0.5235987755982988;  ///< of each beam from the transducer's axis
  double longest_range_m = 120;           ///< slant range at which bottom lock is lost
};

/// Velocity, altitude, attitude of the head and per-beam range (slant * cos(beam angle)); a beam
/// without echo has no range, and with fewer than four there is no velocity.
measurement::BottomVelocity ideal_dvl(const Truth& truth, const Mounting& mounting,
                                      const JanusBeams& beams = {});

/// Speed through the water along the log's x (longitudinal) and y (transverse) axes.
/// distance_m stays empty: the device that counts adds it.
measurement::WaterSpeed ideal_log(const Truth& truth, const Mounting& mounting);

/// An antenna deeper than this hears nothing.
inline constexpr double antenna_awash_depth_m = 0.3;

/// Position, height and velocity of the antenna, the sea surface being the ellipsoid; under water
/// FixType::none and the time alone.
measurement::GnssFix ideal_gnss(const Truth& truth, const Mounting& mounting);

/// Depth of the sensor and the ocean's pressure and temperature there.
measurement::DepthSample ideal_depth(const Truth& truth, const ocean::Ocean& ocean,
                                     const Mounting& mounting);
inline constexpr double water_temperature_k = 283.15;

double depth_at(const Truth& truth, const Mounting& mounting);     ///< of the sensor, down, m
double altitude_at(const Truth& truth, const Mounting& mounting);  ///< of the sensor over the bed

measurement::ActuatorState ideal_actuators(const Truth& truth);

}  // namespace drydock::sensor
