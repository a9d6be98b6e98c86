#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rig_config/rig.hpp"

namespace drydock::motion {

/// A function of time and its first derivative.
struct Varying {
  double value = 0, rate = 0;
};

/// The values that the legs prescribe at one time; SI, radians.
struct Prescribed {
  Varying speed, roll, pitch, yaw;
  double depth_m = 0, descent_mps = 0;
  std::optional<double> rudder_rad;  ///< for turning_circle: held, whatever the heading
};

/// The legs of a mission as functions of the time since its start, C2 for speed and angles:
///   speed  quintic from the previous speed to `speed_mps`, over the whole leg
///   turn   yaw rate and heel rise and fall with quintic ramps, constant between them
///   dive   septic depth; the pitch follows from it: sin(pitch) = -(d depth/dt) / speed
///   s_path heading `amplitude_rad` * sin(2 pi t / period), faded in and out
///   spiral rate of turn from `rate_radps` to `end_rate_radps`, with quintic ramps at both ends
///   zigzag heading to both sides by `amplitude_rad`, changed each half `period_s`
///   turning_circle  the rudder is held; only for a simulated vehicle
///   surface  a dive up to depth 0
/// With `ramp_s`, acceleration, yaw rate and sink rate are constant between quintic ramps of that
/// length; then the speed is C2 at the ramps, and so is the pitch. A lap begins with the heading,
/// depth and speed at the end of the previous lap. So a mission that is meant to repeat ends at the
/// depth at which it begins.
class MissionProfile {
 public:
  /// Throws BadMission for legs that are not possible.
  explicit MissionProfile(const rig_config::MissionConfig& mission);

  Prescribed at(double t) const;
  double lap_s() const { return lap_s_; }
  std::string path_at(double t) const;  ///< in the mission file, of what decides about this time

 private:
  struct Leg {
    rig_config::LegConfig config;
    double begins_s = 0, speed_before = 0, yaw_before = 0, depth_before = 0;
  };

  void add(const rig_config::LegConfig& leg);

  std::vector<Leg> legs_;
  Prescribed begin_, end_;  ///< begin and end of the first lap
  double lap_s_ = 0;
};

}  // namespace drydock::motion
