#pragma once

#include <vector>

#include "rig_config/rig.hpp"

namespace drydock::motion {

/// A function of time and its first derivative.
struct Varying {
  double value = 0, rate = 0;
};

/// What a leg prescribes at one time; SI, radians.
struct Attitude {
  Varying speed, roll, pitch, yaw;
  double depth_m = 0;
};

/// The legs of a mission as smooth functions of the time since its start. Within a leg
///   speed  quintic from the speed before to `speed_mps`, over the whole leg
///   turn   yaw rate and heel rise, hold and fall with quintic ramps
///   dive   septic depth; pitch is what brings it about: sin(pitch) = -(d depth/dt) / speed
///   s_path heading amplitude * sin(2 pi t / period), faded in and out
class MissionProfile {
 public:
  explicit MissionProfile(const rig_config::MissionConfig& mission);

  Attitude at(double t) const;
  double lap_s() const { return lap_s_; }

 private:
  struct Leg {
    rig_config::LegConfig config;
    double begins_s = 0, speed_before = 0, yaw_before = 0, depth_before = 0;
  };

  const Leg& leg_at(double t_in_lap) const;

  std::vector<Leg> legs_;
  double lap_s_ = 0, lap_yaw_ = 0, lap_depth_ = 0;
  Attitude first_;
};

}  // namespace drydock::motion
