#include "hil/steer/joint.hpp"

namespace drydock::steer {

std::vector<Joint> joints_of(const rig_config::MissionConfig& mission) {
  std::vector<Joint> joints;
  if (mission.thruster_vehicle) {
    for (const auto& thruster : mission.thruster_vehicle->thrusters)
      joints.push_back({thruster.name, JointKind::thruster, -thruster.astern_n, thruster.ahead_n});
    return joints;
  }
  const auto& vehicle = mission.vehicle.value();
  const auto surface = [&](const char* name, const rig_config::SurfaceConfig& config) {
    joints.push_back({name, JointKind::surface, -config.limit_rad, config.limit_rad});
  };
  surface("rudder", vehicle.rudder);
  surface("stern_planes", vehicle.stern_planes);
  surface("bow_planes", vehicle.bow_planes);
  joints.push_back({"propeller", JointKind::propeller, 0, vehicle.propeller.limit_radps});
  return joints;
}

std::optional<double> value_for(const Joint& joint, const measurement::JointOrder& order) {
  switch (joint.kind) {
    case JointKind::surface: return order.position_rad;
    case JointKind::propeller: return order.velocity_radps;
    case JointKind::thruster: return order.effort_n;
  }
  return {};
}

std::string_view what_it_obeys(JointKind kind) {
  switch (kind) {
    case JointKind::surface: return "a position in rad";
    case JointKind::propeller: return "a velocity in rad/s";
    case JointKind::thruster: return "an effort in N";
  }
  return "";
}

}  // namespace drydock::steer
