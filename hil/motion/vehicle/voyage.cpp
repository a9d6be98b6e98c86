#include "hil/motion/vehicle/voyage.hpp"

#include "estimators/frame/attitude.hpp"
#include "hil/motion/vehicle/keep_in_water.hpp"

namespace drydock::motion {

namespace {

double seconds_of(std::int64_t step) { return static_cast<double>(step * voyage_step_ns) * 1e-9; }

}  // namespace

Voyage::Voyage(const rig_config::MissionConfig& mission, const Helm& helm, Edges edges)
    : motion_(mission, edges), helm_(helm), edges_(edges), steps_(first(mission)) {}

VoyageStep Voyage::first(const rig_config::MissionConfig& mission) const {
  VoyageStep step{.state = {},
                  .rate = {},
                  .actuators = {*mission.vehicle, mission.speed_mps},
                  .memory = {},
                  .command = {}};
  step.state.latitude_rad = mission.latitude_rad;
  step.state.longitude_rad = mission.longitude_rad;
  step.state.height_m = -mission.depth_m;
  step.state.body_to_ned = frame::body_to_ned({0, 0, mission.heading_rad});
  step.state.velocity[0] = mission.speed_mps;
  complete(step, 0);
  return step;
}

VoyageStep Voyage::at(std::int64_t step) const {
  return steps_.at(
      step, [this](const VoyageStep& before, std::int64_t index) { return after(before, index); });
}

VoyageStep Voyage::after(const VoyageStep& step, std::int64_t index) const {
  VoyageStep next = step;
  next.state = motion_.step(step.state, step.rate, next.actuators, step.command, seconds_of(index),
                            voyage_step_s);
  if (edges_ == Edges::closed) keep_in_reach(step.state, next.state);
  complete(next, index + 1);
  return next;
}

/// Orders may bring a vehicle where its equations hold no more: there it loses its way.
void Voyage::keep_in_reach(const VehicleState& before, VehicleState& now) const {
  constexpr double largest = 30;  // m/s, rad/s
  const bool holds = now.velocity.allFinite() && now.velocity.cwiseAbs().maxCoeff() < largest;
  if (!holds) {
    now = before;
    now.velocity.setZero();
  }
  keep_in_water(now, motion_.ocean());
}

/// Computes the rate and the command of a step from its state and actuators.
void Voyage::complete(VoyageStep& step, std::int64_t index) const {
  const double t = seconds_of(index);
  step.rate = motion_.rate(step.state, step.actuators.control(), t);
  step.command = helm_.command(index, step.state, step.memory);
}

}  // namespace drydock::motion
