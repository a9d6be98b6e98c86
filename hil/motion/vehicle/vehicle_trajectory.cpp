#include "hil/motion/vehicle/vehicle_trajectory.hpp"

#include <algorithm>

#include "hil/motion/vehicle/vehicle_truth.hpp"

namespace drydock::motion {

VehicleTrajectory::VehicleTrajectory(const rig_config::MissionConfig& mission, Stamp start)
    : helm_(mission), voyage_(mission, helm_, Edges::open), start_(start) {
  helm_.plan().check(mission, ocean());
}

Stamp VehicleTrajectory::end() const {
  return start_ + measurement::from_seconds(helm_.plan().planned_s());
}

Truth truth_at(const Voyage& voyage, Stamp start, Stamp time) {
  const std::int64_t ns = std::max<std::int64_t>((time - start).count(), 0);
  const VoyageStep step = voyage.at(ns / voyage_step_ns);
  const double within = static_cast<double>(ns % voyage_step_ns) * 1e-9;
  const double t = static_cast<double>(ns) * 1e-9;
  VehicleState s = step.state;
  VehicleRate rate = step.rate;
  Actuators actuators = step.actuators;
  if (within > 0) {
    const double begin = static_cast<double>(ns - ns % voyage_step_ns) * 1e-9;
    s = voyage.motion().step(s, step.rate, actuators, step.command, begin, within);
    rate = voyage.motion().rate(s, actuators.control(), t);
  }
  const auto control = actuators.control();

  Truth truth = truth_of(s, rate, acceleration_ned(s, rate, voyage.motion().ocean(), t),
                         voyage.motion().ocean(), t);
  truth.at = time;
  truth.rudder_rad = control.delta_r;
  truth.stern_plane_rad = control.delta_s;
  truth.bow_plane_rad = control.delta_b;
  truth.propeller_radps = actuators.propeller_radps();
  return truth;
}

}  // namespace drydock::motion
