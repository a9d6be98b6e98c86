#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "hil/motion/leg_profile.hpp"

/// Line-of-sight guidance along straight lines between waypoints (Fossen, Handbook of Marine Craft
/// Hydrodynamics and Motion Control, 2nd edition, 2021, chapter 12). Places are metres north and
/// east of where the mission begins. Equation numbers are those of docs/world/waypoints.md.
namespace drydock::motion {

/// A place beside a straight line, m.
struct TrackErrors {
  double along = 0;  ///< from the beginning of the line
  double cross = 0;  ///< positive to starboard of it
};

TrackErrors track_errors(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                         const Eigen::Vector2d& place);

/// What the guidance keeps from step to step.
struct GuidanceMemory {
  std::size_t line = 0;   ///< the number of the waypoint at its beginning
  double integral_s = 0;  ///< of the cross-track error, from the beginning of the line on
  bool over = false;      ///< the last waypoint is behind
};

/// A waypoint that the vehicle has left behind.
struct Passed {
  std::size_t waypoint = 0;  ///< its number from 0 on
  double off_m = 0;          ///< distance in that moment
  bool reached = false;      ///< false: abeam of it, outside of its circle
};

class WaypointGuidance {
 public:
  /// `mission` has a vehicle and two waypoints or more. Throws BadMission for lines that are not
  /// possible.
  explicit WaypointGuidance(const rig_config::MissionConfig& mission);

  /// Goes on to the next line inside the circle of acceptance, eq. (4), or abeam of the waypoint.
  std::optional<Passed> pass(const Eigen::Vector2d& place, GuidanceMemory& memory) const;

  /// Eq. (1) to (3): heading, depth and speed on the line, for the next dt seconds. Behind the
  /// last waypoint the last line goes on.
  Prescribed wanted(const Eigen::Vector2d& place, GuidanceMemory& memory, double dt) const;

  double planned_s() const;  ///< on the lines, in still water
  const std::vector<rig_config::WaypointConfig>& waypoints() const { return waypoints_; }

 private:
  std::vector<rig_config::WaypointConfig> waypoints_;
  double lookahead_m_, integral_gain_mps_;
};

inline Eigen::Vector2d place_of(const rig_config::WaypointConfig& waypoint) {
  return {waypoint.north_m, waypoint.east_m};
}

}  // namespace drydock::motion
