#include "hil/motion/ordered/ordered_thrusters.hpp"

#include <algorithm>

#include "hil/motion/vehicle/helm.hpp"

namespace drydock::motion {

OrderedThrusters::OrderedThrusters(const rig_config::MissionConfig& mission, Stamp start)
    : motion_(mission),
      orders_(mission.thruster_vehicle.value(), start),
      steps_(motion_.first()),
      start_(start) {}

Truth OrderedThrusters::at(Stamp time) const {
  const std::int64_t ns = std::max<std::int64_t>((time - start_).count(), 0);
  const std::int64_t step = ns / voyage_step_ns, within = ns % voyage_step_ns;
  const auto seconds = [](std::int64_t nanoseconds) {
    return static_cast<double>(nanoseconds) * 1e-9;
  };
  ThrusterOrders::Outputs room;
  ThrusterState state = steps_.at(step, [&](const ThrusterState& before, std::int64_t index) {
    return motion_.after(before, orders_.outputs(index, room), seconds(index * voyage_step_ns),
                         voyage_step_s);
  });
  if (within > 0)
    state =
        motion_.after(state, orders_.outputs(step, room), seconds(ns - within), seconds(within));
  Truth truth = motion_.truth(state, seconds(ns));
  truth.at = time;
  return truth;
}

}  // namespace drydock::motion
