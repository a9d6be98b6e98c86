#include "hil/motion/vehicle/voyage.hpp"

#include "estimators/frame/attitude.hpp"
#include "hil/motion/vehicle/keep_in_water.hpp"

namespace drydock::motion {

namespace {

constexpr std::int64_t block_steps = 1024;  // 10.24 s
constexpr std::size_t kept_blocks = 4;

double seconds_of(std::int64_t step) { return static_cast<double>(step * voyage_step_ns) * 1e-9; }

}  // namespace

Voyage::Voyage(const rig_config::MissionConfig& mission, const Helm& helm, Edges edges)
    : motion_(mission), helm_(helm), edges_(edges) {
  starts_.push_back(first(mission));
}

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
  const std::lock_guard lock(mutex_);
  const std::int64_t index = step / block_steps;
  while (static_cast<std::int64_t>(starts_.size()) <= index) {
    const auto last = static_cast<std::int64_t>(starts_.size()) - 1;
    extend(block(last), block_steps);
  }
  const auto within = static_cast<std::size_t>(step % block_steps);
  Block& there = block(index);
  extend(there, within + 1);
  return there.steps[within];
}

/// Returns the block, which may be in memory already, with at least its first step.
Voyage::Block& Voyage::block(std::int64_t index) const {
  for (auto found = blocks_.begin(); found != blocks_.end(); ++found)
    if (found->index == index) {
      blocks_.splice(blocks_.begin(), blocks_, found);
      return blocks_.front();
    }
  if (blocks_.size() < kept_blocks) {
    blocks_.emplace_front().steps.reserve(block_steps);
  } else {
    blocks_.splice(blocks_.begin(), blocks_, std::prev(blocks_.end()));
  }
  blocks_.front().index = index;
  blocks_.front().steps.assign(1, starts_[static_cast<std::size_t>(index)]);
  return blocks_.front();
}

void Voyage::extend(Block& block, std::size_t steps) const {
  const std::int64_t begins = block.index * block_steps;
  while (block.steps.size() < steps)
    block.steps.push_back(
        after(block.steps.back(), begins + static_cast<std::int64_t>(block.steps.size()) - 1));
  const auto next = static_cast<std::size_t>(block.index + 1);
  if (steps == block_steps && starts_.size() == next)
    starts_.push_back(after(block.steps.back(), begins + block_steps - 1));
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
