#pragma once

#include <numbers>

#include "hil/motion/kinematic_trajectory.hpp"

namespace drydock::motion {

inline constexpr double degree = std::numbers::pi / 180;
inline const Stamp start = measurement::stamp_from_ns(1'700'000'000'000'000'000);

inline Stamp at_s(double t) { return start + measurement::from_seconds(t); }

/// Straight, turn, dive, S path, climb, at 47 deg north: 600 s per lap.
inline rig_config::MissionConfig varied_mission() {
  using enum rig_config::LegKind;
  rig_config::MissionConfig mission;
  mission.latitude_rad = 47 * degree;
  mission.longitude_rad = 8 * degree;
  mission.depth_m = 5;
  mission.heading_rad = 30 * degree;
  mission.speed_mps = 1.5;
  mission.legs = {
      {.kind = straight, .duration_s = 60, .speed_mps = 2},
      {.kind = turn, .duration_s = 90, .turn_rad = 150 * degree, .speed_mps = 2, .roll_rad = -0.1},
      {.kind = dive, .duration_s = 150, .depth_change_m = 40, .speed_mps = 1.8},
      {.kind = s_path, .duration_s = 150, .speed_mps = 1.8, .amplitude_rad = 0.5, .period_s = 60},
      {.kind = dive, .duration_s = 150, .depth_change_m = -40, .speed_mps = 1.5}};
  return mission;
}

}  // namespace drydock::motion
