#include "hil/motion/track.hpp"

#include <cmath>
#include <numbers>

namespace drydock::motion {

namespace {

constexpr double steepest_rad = 85 * std::numbers::pi / 180;

}  // namespace

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
    if (!next || std::abs(vehicle.state()[element::pitch]) > steepest_rad) break;
    vehicle.step(command, track_step_s);
  }
  return track;
}

}  // namespace drydock::motion
