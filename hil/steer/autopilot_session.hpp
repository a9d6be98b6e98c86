#pragma once

#include <array>
#include <optional>
#include <string>

#include "hil/motion/steered/steered_trajectory.hpp"
#include "hil/steer/servo_outputs.hpp"
#include "rig_config/mission.hpp"

namespace drydock::steer {

using motion::Stamp;

struct SessionCounters {
  std::uint64_t steps = 0;
  std::uint64_t repeats = 0;   ///< packets with the count of the one before: answered, no step
  std::uint64_t lost = 0;      ///< counts that never came
  std::uint64_t restarts = 0;  ///< the count began anew: another run of the autopilot
  std::uint64_t refused = 0;   ///< packets that are none: wrong magic, length or rate
};

/// The physics in lockstep with an autopilot: each packet makes the vehicle go on by one step, and
/// gets the state after it. The autopilot waits for that.
class AutopilotSession {
 public:
  /// The motion must outlive the session. Positions count from where the mission begins, at the
  /// surface.
  AutopilotSession(motion::SteeredTrajectory& motion, const rig_config::MissionConfig& mission);

  /// The answer to a packet; `now` is bench time. Empty: the packet is refused. Valid until the
  /// next call.
  std::string_view answer(wire::Bytes packet, Stamp now);

  const SessionCounters& counters() const { return counters_; }
  /// What a person should know about the session, as lines.
  std::vector<std::string> notes() const;

 private:
  void step(const ServoOutputs& servo, Stamp now);
  void note_count(std::uint32_t count);

  motion::SteeredTrajectory& motion_;
  frame::Position origin_;
  std::optional<std::uint32_t> last_count_;
  SessionCounters counters_;
  std::array<char, 1024> line_{};
  std::string_view last_answer_;
};

}  // namespace drydock::steer
