#include "hil/steer/joint_helm.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
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
    : actuators_(joints_of(mission)), thrusters_(thrusters_of(mission)), say_(std::move(say)) {
  if (!thrusters_.empty()) allocation_.emplace(thrusters_);
}

void JointHelm::refuse(const std::string& name, const std::string& why) {
  ++counters_.refused;
  if (told_.size() < 64 && told_.insert(name).second) say_(why);
}

void JointHelm::order(std::span<const measurement::JointOrder> orders, Stamp now) {
  ++counters_.orders;
  for (const auto& order : orders) {
    const auto joint = std::ranges::find(joints(), order.name, &Joint::name);
    if (joint == joints().end()) {
      refuse(order.name, fmt::format("an order for \"{}\", allowed: {}", order.name.substr(0, 64),
                                     names_of(joints())));
    } else if (const auto value = value_for(*joint, order)) {
      give(static_cast<std::size_t>(joint - joints().begin()), *value, now);
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
  const Joint& joint = joints()[index];
  const double allowed = std::clamp(value, joint.least, joint.most);
  if (allowed != value) ++counters_.limited;
  actuators_.order(index, share_of(index, allowed), now);
}

double JointHelm::share_of(std::size_t index, double value) const {
  const Joint& joint = joints()[index];
  if (joint.kind == JointKind::thruster) return thrusters_[index].command_for(value);
  return joint.most > 0 ? value / joint.most : 0;
}

std::span<const double> JointHelm::outputs(Stamp now, const motion::Truth& vehicle) {
  return actuators_.outputs(now, vehicle, [this](const Joint& joint) {
    ++counters_.timeouts;
    say_(words_of_time_out(joint));
  });
}

std::vector<std::string> notes_of(std::string_view from, const HelmCounters& counters,
                                  std::uint64_t unusable) {
  return {
      fmt::format("{}: {} orders for joints, {} for force and moment; {} beyond a limit, {} "
                  "refused, {} without "
                  "a meaning; {} times a joint went to its safe state",
                  from, counters.orders, counters.wrenches, counters.limited, counters.refused,
                  unusable, counters.timeouts)};
}

}  // namespace drydock::steer
