#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drivers/measurement/joint_order.hpp"
#include "rig_config/mission.hpp"

namespace drydock::steer {

/// What drives a joint.
enum class JointKind : std::uint8_t { surface, propeller, thruster };

/// A joint of the vehicle and its limits, in the unit of its order: rad, rad/s or N.
struct Joint {
  std::string name;
  JointKind kind{};
  double least = 0, most = 0;
};

/// The joints in the order in which the vehicle takes its outputs: rudder, stern_planes,
/// bow_planes, propeller; or the thrusters under the names of the vehicle file.
std::vector<Joint> joints_of(const rig_config::MissionConfig& mission);

/// The value of an order that this joint obeys: the position of a surface, the velocity of a
/// propeller, the effort of a thruster. Empty: the order does not have it.
std::optional<double> value_for(const Joint& joint, const measurement::JointOrder& order);

/// "a position in rad"
std::string_view what_it_obeys(JointKind kind);

}  // namespace drydock::steer
