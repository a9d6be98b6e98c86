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

/// A vehicle at one time of a manoeuvre. Time in s; state and surfaces as in hydrodynamics::Model.
struct TrackPoint {
  double t = 0;
  hydrodynamics::State state = hydrodynamics::State::Zero();
  hydrodynamics::Control control;  ///< the actual positions of the actuators
  Command command;                 ///< from this time on
};

using Track = std::vector<TrackPoint>;  ///< one point every `track_step_s` from t = 0

inline constexpr double track_step_s = 0.02;

/// The command for a time and a state; empty when the manoeuvre is over.
using Steering = std::function<std::optional<Command>(double t, const hydrodynamics::State& state)>;

/// A track ends at this pitch, because Euler angles cannot pass 90 degrees.
inline constexpr double steepest_pitch_rad = 1.48;
bool too_steep(const hydrodynamics::State& state);

/// The rate at which a vehicle gains depth through the water, m/s.
double descent_rate(const hydrodynamics::State& state);

/// Steers a vehicle from straight level motion at `speed_mps`, at the origin, heading north. Asks
/// for a command at each step. The track ends with the manoeuvre, after `limit_s`, if the state is
/// too_steep(), or before a state that is not finite.
Track sail(const rig_config::VehicleConfig& vehicle, double speed_mps, double limit_s,
           const Steering& steering);

}  // namespace drydock::motion
