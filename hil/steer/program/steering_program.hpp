#pragma once

#include <string>
#include <vector>

#include "estimators/external/hello.hpp"
#include "estimators/external/program_dialogue.hpp"
#include "estimators/external/step_line.hpp"
#include "hil/motion/truth.hpp"
#include "hil/steer/joint_helm.hpp"
#include "hil/steer/program/orders_answer.hpp"
#include "rig_config/mission.hpp"

namespace drydock::steer {

/// A program that steers, as a child process: docs/world/steering-program.md. It is sent the
/// measurements of each step and its orders go to a helm.
class SteeringProgram {
 public:
  using Devices = std::vector<external::Hello::Device>;

  /// `mission.steering` must be set. The helm must outlive it. `devices`: by `Origin::device`.
  SteeringProgram(const std::string& rig, const rig_config::MissionConfig& mission,
                  const Devices& devices, JointHelm& helm, JointHelm::Say say);

  /// It belongs to the step that ends next.
  void receive(const measurement::Measurement& measurement);

  /// Ends a step and waits for its orders. `truth` is sent if the mission asks for it.
  void end_step(Stamp now, const motion::Truth& truth);

  const pipeline::PeerAccount& account() const { return dialogue_.account(); }

 private:
  std::string_view line_of(Stamp now, const motion::Truth& truth);
  void obey();

  bool tells_truth_;
  std::vector<std::string> names_;
  external::StepLines lines_;
  std::string line_;  ///< with the truth
  JointHelm& helm_;
  OrdersAnswer answer_;  ///< what was read last
  Stamp now_{};
  std::vector<pipeline::Sample> samples_;
  std::uint64_t step_ = 0;
  external::ProgramDialogue dialogue_;
};

}  // namespace drydock::steer
