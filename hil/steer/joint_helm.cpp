#include "hil/steer/joint_helm.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

namespace drydock::steer {
namespace {

std::vector<motion::Thruster> thrusters_of(const rig_config::MissionConfig& mission) {
  std::vector<motion::Thruster> thrusters;
  if (mission.thruster_vehicle)
    for (const auto& config : mission.thruster_vehicle->thrusters) thrusters.emplace_back(config);
  return thrusters;
}

std::string names_of(const std::vector<Joint>& joints) {
  std::vector<std::string> names;
  names.reserve(joints.size());
  for (const Joint& joint : joints) names.push_back(joint.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

JointHelm::JointHelm(const rig_config::MissionConfig& mission, Say say)
    : joints_(joints_of(mission)),
      thrusters_(thrusters_of(mission)),
      say_(std::move(say)),
      channels_(joints_.size()),
      outputs_(joints_.size(), 0) {
  if (!thrusters_.empty()) allocation_.emplace(thrusters_);
}

void JointHelm::refuse(const std::string& name, const std::string& why) {
  ++counters_.refused;
  if (told_.size() < 64 && told_.insert(name).second) say_(why);
}

void JointHelm::order(std::span<const measurement::JointOrder> orders, Stamp now) {
  ++counters_.orders;
  for (const auto& order : orders) {
    const auto joint = std::ranges::find(joints_, order.name, &Joint::name);
    if (joint == joints_.end()) {
      refuse(order.name, fmt::format("an order for \"{}\", allowed: {}", order.name.substr(0, 64),
                                     names_of(joints_)));
    } else if (const auto value = value_for(*joint, order)) {
      give(static_cast<std::size_t>(joint - joints_.begin()), *value, now);
    } else {
      refuse(order.name, fmt::format("an order for {} without a value, it obeys {}", joint->name,
                                     what_it_obeys(joint->kind)));
    }
  }
}

void JointHelm::order(const measurement::BodyWrench& wrench, Stamp now) {
  ++counters_.wrenches;
  if (!allocation_)
    return refuse("wrench", "an order for force and moment, allowed: for a vehicle with thrusters");
  const auto pushes = allocation_->pushes(wrench);
  for (std::size_t i = 0; i < pushes.size(); ++i) give(i, pushes[i], now);
}

void JointHelm::give(std::size_t index, double value, Stamp now) {
  const Joint& joint = joints_[index];
  const JointTrouble trouble = trouble_of(joint.name);
  if (trouble.deaf) return;
  const double allowed = std::clamp(value, joint.least, joint.most);
  if (allowed != value) ++counters_.limited;
  channels_[index].coming.push_back({now + trouble.late, allowed});
}

JointTrouble JointHelm::trouble_of(const std::string& name) const {
  const auto found = troubles_.find(name);
  return found == troubles_.end() ? JointTrouble{} : found->second;
}

void JointHelm::follow(Channel& channel, const std::string& name, Stamp now) {
  while (!channel.coming.empty() && channel.coming.front().at <= now) {
    channel.held = channel.coming.front();
    channel.coming.pop_front();
  }
  if (!channel.held || now - channel.held->at <= patience) return;
  channel.held.reset();
  ++counters_.timeouts;
  say_(fmt::format("no order for {} for {} s: it goes to its safe state", name, patience.count()));
}

double JointHelm::share_of(std::size_t index) const {
  const auto& held = channels_[index].held;
  if (!held) return 0;
  const Joint& joint = joints_[index];
  if (joint.kind == JointKind::thruster) return thrusters_[index].command_for(held->value);
  return joint.most > 0 ? held->value / joint.most : 0;
}

double JointHelm::share_while_stuck(std::size_t index, const motion::Truth& vehicle) {
  const Joint& joint = joints_[index];
  if (joint.kind != JointKind::surface || joint.most == 0) return 0;
  auto& stands = channels_[index].stuck_at_rad;
  if (!stands)
    stands =
        std::array{vehicle.rudder_rad, vehicle.stern_plane_rad, vehicle.bow_plane_rad}.at(index);
  return *stands / joint.most;
}

std::span<const double> JointHelm::outputs(Stamp now, const motion::Truth& vehicle) {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const JointTrouble trouble = trouble_of(joints_[i].name);
    follow(channels_[i], joints_[i].name, now);
    if (trouble.stuck) {
      outputs_[i] = share_while_stuck(i, vehicle);
      continue;
    }
    channels_[i].stuck_at_rad.reset();
    if (!trouble.powerless) outputs_[i] = share_of(i);
    if (trouble.powerless && joints_[i].kind != JointKind::surface) outputs_[i] = 0;
  }
  return outputs_;
}

std::vector<std::string> notes_of(const HelmCounters& counters, std::uint64_t unusable) {
  return {
      fmt::format("dds: {} orders for joints, {} for force and moment; {} beyond a limit, {} "
                  "refused, {} without "
                  "a meaning; {} times a joint went to its safe state",
                  counters.orders, counters.wrenches, counters.limited, counters.refused, unusable,
                  counters.timeouts)};
}

}  // namespace drydock::steer
