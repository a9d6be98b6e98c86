#include "hil/motion/vehicle/mission_helm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "estimators/frame/earth.hpp"
#include "hil/motion/bad_mission.hpp"

namespace drydock::motion {

MissionHelm::MissionHelm(const rig_config::MissionConfig& mission)
    : profile_(mission), autopilot_(mission.vehicle.value()) {}

void MissionHelm::check_plan(const rig_config::MissionConfig& mission,
                             const ocean::Ocean& ocean) const {
  const auto& propeller = mission.vehicle->propeller;
  const double fastest = propeller.advance_m * propeller.limit_radps;
  double latitude = mission.latitude_rad, longitude = mission.longitude_rad;
  for (int second = 0; second <= lap_s(); ++second) {
    const double t = second;
    const Prescribed plan = profile_.at(t);
    if (plan.speed.value > fastest)
      throw BadMission(profile_.path_at(t),
                       fmt::format("mission: after {:.0f} s the vehicle would need {:.2f} m/s, its "
                                   "propeller gives {:.2f}",
                                   t, plan.speed.value, fastest));
    const double bed_m = ocean.bed_depth_m(latitude, longitude);
    if (plan.depth_m >= bed_m)
      throw BadMission(
          profile_.path_at(t),
          fmt::format("mission: after {:.0f} s the vehicle would be {:.1f} m deep, at or below the "
                      "sea bed ({:.1f} m there)",
                      t, plan.depth_m, bed_m));
    const Eigen::Vector3d current = ocean.current_ned(plan.depth_m, t);
    const double level = std::sqrt(
        std::max(plan.speed.value * plan.speed.value - plan.descent_mps * plan.descent_mps, 0.0));
    latitude += (level * std::cos(plan.yaw.value) + current.x()) / frame::meridian_radius(latitude);
    longitude += (level * std::sin(plan.yaw.value) + current.y()) /
                 (frame::transverse_radius(latitude) * std::cos(latitude));
  }
}

Command MissionHelm::command(std::int64_t step, const VehicleState& state,
                             AutopilotMemory& memory) const {
  const double t = static_cast<double>(step * voyage_step_ns) * 1e-9;
  return autopilot_.steer(profile_.at(t), state, memory, voyage_step_s);
}

}  // namespace drydock::motion
