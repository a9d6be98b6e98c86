#include "hil/bench/program_in_step.hpp"

#include <algorithm>
#include <utility>

#include "estimators/setup/told_devices.hpp"

namespace drydock::bench {

namespace {

/// The sensors see the motion between two moments as linear.
constexpr std::chrono::milliseconds longest_motion_step{10};

}  // namespace

ProgramInStep::ProgramInStep(const rig_config::Rig& rig, motion::SteeredTrajectory& motion,
                             steer::JointTroublesAt troubles, const steer::JointHelm::Say& say)
    : motion_(motion),
      troubles_(std::move(troubles)),
      period_(measurement::from_seconds(rig.mission.steering.value().step_s)),
      helm_(rig.mission, say),
      program_(rig.name, rig.mission, setup::told_devices(rig), helm_, say),
      next_(motion.start()) {}

void ProgramInStep::act(measurement::Stamp now) {
  program_.end_step(now, motion_.latest());
  next_ = now + period_;
  for (measurement::Stamp at = now; at < next_;) {
    const auto step = std::min<std::chrono::nanoseconds>(longest_motion_step, next_ - at);
    helm_.set_troubles(troubles_(at));
    const auto outputs = helm_.outputs(at, motion_.latest());
    at += step;
    motion_.step(outputs, measurement::seconds(step), at);
  }
}

}  // namespace drydock::bench
