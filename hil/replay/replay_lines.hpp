#pragma once

#include <cstdio>

#include "drivers/host/follower.hpp"
#include "drivers/text/json_lines.hpp"
#include "rig_config/rig.hpp"

namespace drydock::replay {

/// Writes measurements and estimates of a rig as JSON Lines. Angles are in degrees; numbers have
/// all their digits.
class ReplayLines final : public host::Follower {
 public:
  ReplayLines(const rig_config::Rig& rig, std::FILE* out) : rig_(rig), lines_(out) {}

  void on_measurement(const measurement::Measurement& measurement) override;
  void on_estimate(const host::Estimate& estimate) override;
  bool flush() { return lines_.flush(); }  ///< false after a write failed

 private:
  const rig_config::Rig& rig_;
  text::JsonLines lines_;
};

}  // namespace drydock::replay
