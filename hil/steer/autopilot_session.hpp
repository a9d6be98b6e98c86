#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "hil/motion/steered/steered_trajectory.hpp"
#include "hil/steer/joint_actuators.hpp"
#include "hil/steer/servo_outputs.hpp"
#include "rig_config/mission.hpp"

namespace drydock::steer {

struct SessionCounters {
  std::uint64_t steps = 0;
  std::uint64_t repeats = 0;   ///< packets with the count of the one before: answered, no step
  std::uint64_t lost = 0;      ///< counts that never came
  std::uint64_t late = 0;      ///< packets from before the last one: no answer
  std::uint64_t restarts = 0;  ///< the count began anew: another run of the autopilot
  std::uint64_t refused = 0;   ///< packets that are none: wrong magic, length or rate
  std::uint64_t others = 0;    ///< packets of a second autopilot beside the first: no answer
  std::uint64_t timeouts = 0;  ///< how often a joint that hears nothing went to its safe state
};

/// Tells one program that sends packets from another, as its address and port do.
using Sender = std::uint64_t;

/// The physics in lockstep with an autopilot: each packet makes the vehicle go on by one step, and
/// gets the state after it. The autopilot waits for that. A second autopilot gets no answer before
/// the first is silent.
class AutopilotSession {
 public:
  /// An autopilot that waits for an answer repeats its packet each second; one that is silent for
  /// this long has gone.
  static constexpr std::chrono::seconds longest_silence{2};

  /// The motion must outlive the session. Positions count from where the mission begins, at the
  /// surface.
  AutopilotSession(motion::SteeredTrajectory& motion, const rig_config::MissionConfig& mission);

  /// The answer to a packet; `now` is bench time. Empty: there is none. Valid until the next call.
  std::string_view answer(wire::Bytes packet, Stamp now, Sender from = 0);

  /// The faults of the actuators from now on.
  void set_troubles(JointTroubles troubles) { actuators_.set_troubles(std::move(troubles)); }

  const SessionCounters& counters() const { return counters_; }
  /// What a person should know about the session, as lines.
  std::vector<std::string> notes() const;

 private:
  bool admits(Sender from, Stamp now);
  bool takes(std::uint32_t count);
  void begin_run();
  void step(const ServoOutputs& servo, Stamp now);
  void order(std::span<const double> outputs, Stamp now);

  motion::SteeredTrajectory& motion_;
  JointActuators actuators_;
  bool has_fins_;
  frame::Position origin_;
  std::optional<Sender> partner_;
  Stamp heard_at_{};
  std::optional<std::uint32_t> last_count_;
  double run_began_s_ = 0;  ///< in time of the motion
  SessionCounters counters_;
  std::array<char, 1024> line_{};
  std::string_view last_answer_;
};

}  // namespace drydock::steer
