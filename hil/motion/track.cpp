#include "hil/motion/track.hpp"

#include <cmath>

namespace drydock::motion {

double descent_rate(const hydrodynamics::State& s) {
  using namespace element;
  return -std::sin(s[pitch]) * s[u] +
         std::cos(s[pitch]) * (std::sin(s[roll]) * s[v] + std::cos(s[roll]) * s[w]);
}

bool too_steep(const hydrodynamics::State& state) {
  return !(std::abs(state[element::pitch]) <= steepest_pitch_rad);
}

Track sail(const rig_config::VehicleConfig& config, double speed_mps, double limit_s,
           const Steering& steering) {
  hydrodynamics::State state = hydrodynamics::State::Zero();
  state[0] = speed_mps;
  SimulatedVehicle vehicle(config, state);
  Track track;
  Command command{0, 0, 0, speed_mps};
  const auto steps = std::lround(limit_s / track_step_s);
  for (long i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / std::lround(1 / track_step_s);
    const auto next = steering(t, vehicle.state());
    if (next) command = *next;
    track.push_back({t, vehicle.state(), vehicle.actuators().control(), command});
    if (!next || too_steep(vehicle.state())) break;
    vehicle.step(command, track_step_s);
    if (!vehicle.state().allFinite()) break;
  }
  return track;
}

}  // namespace drydock::motion
