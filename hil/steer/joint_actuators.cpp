#include "hil/steer/joint_actuators.hpp"

#include <fmt/format.h>

#include <array>

namespace drydock::steer {

void JointActuators::order(std::size_t joint, double share, Stamp now) {
  const JointTrouble trouble = trouble_of(joints_[joint].name);
  if (!trouble.deaf) channels_[joint].coming.push_back({now + trouble.late, share});
}

JointTrouble JointActuators::trouble_of(const std::string& name) const {
  const auto found = troubles_.find(name);
  return found == troubles_.end() ? JointTrouble{} : found->second;
}

bool JointActuators::follow(Channel& channel, Stamp now) {
  while (!channel.coming.empty() && channel.coming.front().at <= now) {
    channel.held = channel.coming.front();
    channel.coming.pop_front();
  }
  if (!channel.held || now - channel.held->at <= patience) return true;
  channel.held.reset();
  return false;
}

double JointActuators::share_while_stuck(std::size_t index, const motion::Truth& vehicle) {
  const Joint& joint = joints_[index];
  if (joint.kind != JointKind::surface || joint.most == 0) return 0;
  auto& stands = channels_[index].stuck_at_rad;
  if (!stands)
    stands =
        std::array{vehicle.rudder_rad, vehicle.stern_plane_rad, vehicle.bow_plane_rad}.at(index);
  return *stands / joint.most;
}

std::span<const double> JointActuators::outputs(Stamp now, const motion::Truth& vehicle,
                                                const TimedOut& timed_out) {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const JointTrouble trouble = trouble_of(joints_[i].name);
    Channel& channel = channels_[i];
    if (!follow(channel, now)) timed_out(joints_[i]);
    if (trouble.stuck) {
      outputs_[i] = share_while_stuck(i, vehicle);
      continue;
    }
    channel.stuck_at_rad.reset();
    if (!trouble.powerless) outputs_[i] = channel.held ? channel.held->share : 0;
    if (trouble.powerless && joints_[i].kind != JointKind::surface) outputs_[i] = 0;
  }
  return outputs_;
}

std::string words_of_time_out(const Joint& joint) {
  return fmt::format("no order for {} for {} s: it goes to its safe state", joint.name,
                     JointActuators::patience.count());
}

}  // namespace drydock::steer
