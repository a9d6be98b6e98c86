#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "hil/motion/vehicle/simulated_vehicle.hpp"

namespace drydock::motion {

/// The elements of hydrodynamics::State.
namespace element {
enum : int { u, v, w, p, q, r, x, y, z, roll, pitch, yaw };
}

/// A vehicle at one time of a manoeuvre. s; state and surfaces as in hydrodynamics::Model.
struct TrackPoint {
  double t = 0;
  hydrodynamics::State state = hydrodynamics::State::Zero();
  hydrodynamics::Control control;  ///< where the actuators are
  Command command;                 ///< from here on
};

using Track = std::vector<TrackPoint>;  ///< each `track_step_s` from t = 0 on

inline constexpr double track_step_s = 0.02;

/// What is commanded at a time in a state; nothing when the manoeuvre is over.
using Steering = std::function<std::optional<Command>(double t, const hydrodynamics::State& state)>;

/// Beyond it a track ends: Euler angles cannot pass 90 degrees.
inline constexpr double steepest_pitch_rad = 1.48;
bool too_steep(const hydrodynamics::State& state);

/// How fast a vehicle gains depth through the water, m/s.
double descent_rate(const hydrodynamics::State& state);

/// Steers a vehicle from straight level motion at `speed_mps`, at the origin, heading north; a
/// command is asked for at each step. Ends with the manoeuvre, after `limit_s`, where the
/// state is too_steep() or before it is no number.
Track sail(const rig_config::VehicleConfig& vehicle, double speed_mps, double limit_s,
           const Steering& steering);

}  // namespace drydock::motion
