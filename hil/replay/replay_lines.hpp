#pragma once

#include <cstdio>

#include "drivers/measurement/measurement.hpp"
#include "drivers/text/json_lines.hpp"
#include "estimators/pipeline/inertial/navigation_estimate.hpp"
#include "rig_config/rig.hpp"

namespace drydock::replay {

/// Writes measurements and estimates of a rig as JSON Lines. Angles are in degrees; numbers have
/// all their digits.
class ReplayLines {
 public:
  ReplayLines(const rig_config::Rig& rig, std::FILE* out) : rig_(rig), lines_(out) {}

  void write(const measurement::Measurement& measurement);
  void write(const pipeline::AttitudeEstimate& estimate);
  void write(const pipeline::NavigationEstimate& estimate);
  bool flush() { return lines_.flush(); }  ///< false after a write failed

 private:
  const rig_config::Rig& rig_;
  text::JsonLines lines_;
};

}  // namespace drydock::replay
