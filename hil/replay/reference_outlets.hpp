#pragma once

#include <cstdio>
#include <optional>
#include <string>

#include "drivers/host/follower.hpp"
#include "hil/replay/reference_check.hpp"
#include "hil/replay/replay_rig.hpp"
#include "hil/replay/topics_follower.hpp"

namespace drydock::replay {

/// The references of a replay: those that it is compared with, those that it writes.
class ReferenceOutlets {
 public:
  /// Reads `check` of the options, which is valid only for the same part of the recording and the
  /// same faults. Throws std::runtime_error with one line.
  ReferenceOutlets(const RigReplayOptions& options,
                   const std::vector<rig_config::FaultConfig>& faults);
  ReferenceOutlets(const ReferenceOutlets&) = delete;  // its followers point into it
  ReferenceOutlets& operator=(const ReferenceOutlets&) = delete;

  void follow(host::Followers& followers, const rig_config::Rig& rig);
  /// At the end of the replay; `whole`: it was not interrupted. Writes the new references, tells
  /// `err` what came out, and returns false if the replay differs from the old ones.
  bool finish(bool whole, std::FILE* err);

 private:
  const RigReplayOptions& options_;
  std::string part_;  ///< in words, with the faults
  std::optional<ReferenceCheck> check_;
  std::optional<ReferenceMaker> maker_;
  std::optional<TopicsFollower> checked_, made_;
};

}  // namespace drydock::replay
