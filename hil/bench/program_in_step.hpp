#pragma once

#include "drivers/shell/lockstep.hpp"
#include "hil/motion/steered/steered_trajectory.hpp"
#include "hil/steer/program/steering_program.hpp"
#include "rig_config/rig.hpp"

namespace drydock::bench {

/// A program that steers the vehicle in virtual time.
class ProgramInStep final : public shell::Actor {
 public:
  /// Rig and motion must outlive it. `troubles`: the faults of the actuators.
  ProgramInStep(const rig_config::Rig& rig, motion::SteeredTrajectory& motion,
                steer::JointTroublesAt troubles, const steer::JointHelm::Say& say);

  std::optional<measurement::Stamp> deadline() const override { return next_; }
  /// Asks the program, and moves the vehicle until its next step: sensors ask for that motion
  /// later.
  void act(measurement::Stamp now) override;
  void receive(const measurement::Measurement& m) { program_.receive(m); }

  const pipeline::PeerAccount& account() const { return program_.account(); }
  /// How the orders went, as lines for the end of a run.
  std::vector<std::string> notes() const {
    return steer::notes_of("program", helm_.counters(), account().malformed + account().not_finite);
  }

 private:
  motion::SteeredTrajectory& motion_;
  steer::JointTroublesAt troubles_;
  std::chrono::nanoseconds period_;
  steer::JointHelm helm_;
  steer::SteeringProgram program_;
  measurement::Stamp next_;
};

}  // namespace drydock::bench
