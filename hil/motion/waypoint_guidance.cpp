#include "hil/motion/waypoint_guidance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "hil/motion/bad_mission.hpp"

namespace drydock::motion {

namespace {

using rig_config::WaypointConfig;

constexpr double circle_lengths = 2;     // Fossen's guideline
constexpr double lookahead_lengths = 4;  // shorter ones make the NPS AUV II swing about its line
constexpr double steepest_slope = 1 / std::numbers::sqrt3;  // 30 deg, see autopilot.hpp

double distance_m(const WaypointConfig& a, const WaypointConfig& b) {
  return (place_of(b) - place_of(a)).norm();
}

[[noreturn]] void refuse(std::size_t waypoint, const char* key, const std::string& why) {
  throw BadMission(fmt::format("/waypoint/{}{}", waypoint, key),
                   fmt::format("mission waypoint {}: {}", waypoint + 1, why));
}

void check(const std::vector<WaypointConfig>& waypoints) {
  for (std::size_t i = 1; i < waypoints.size(); ++i) {
    const double length_m = distance_m(waypoints[i - 1], waypoints[i]);
    if (!(length_m > 0)) refuse(i, "", "it is at the place of the one before it");
    if (!(waypoints[i].speed_mps > 0)) refuse(i, "", "its line needs a speed_mps above 0");
    if (std::abs(waypoints[i].depth_m - waypoints[i - 1].depth_m) > steepest_slope * length_m)
      refuse(i, "/depth_m",
             "its line is steeper than 30 deg; allow a longer way or less change of depth");
  }
}

}  // namespace

TrackErrors track_errors(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                         const Eigen::Vector2d& place) {
  const Eigen::Vector2d ahead = (to - from).normalized(), starboard(-ahead.y(), ahead.x());
  return {ahead.dot(place - from), starboard.dot(place - from)};
}

WaypointGuidance::WaypointGuidance(const rig_config::MissionConfig& mission)
    : waypoints_(mission.waypoints),
      lookahead_m_(mission.guidance.lookahead_m),
      integral_gain_mps_(mission.guidance.integral_gain_mps) {
  if (waypoints_.size() < 2) throw BadMission("/waypoint", "mission: a line needs two waypoints");
  const double length_m = mission.vehicle.value().length_m;
  if (lookahead_m_ == 0) lookahead_m_ = lookahead_lengths * length_m;
  for (WaypointConfig& waypoint : waypoints_)
    if (waypoint.radius_m == 0) waypoint.radius_m = circle_lengths * length_m;
  check(waypoints_);
}

std::optional<Passed> WaypointGuidance::pass(const Eigen::Vector2d& place,
                                             GuidanceMemory& memory) const {
  if (memory.over) return {};
  const WaypointConfig &from = waypoints_[memory.line], &to = waypoints_[memory.line + 1];
  const double off_m = (place_of(to) - place).norm();
  const bool reached = off_m <= to.radius_m;
  const bool abeam =
      track_errors(place_of(from), place_of(to), place).along >= distance_m(from, to);
  if (!reached && !abeam) return {};
  const std::size_t passed = memory.line + 1;
  memory.over = passed + 1 == waypoints_.size();
  if (!memory.over) memory = {.line = passed};
  return Passed{passed, off_m, reached};
}

Prescribed WaypointGuidance::wanted(const Eigen::Vector2d& place, GuidanceMemory& memory,
                                    double dt) const {
  const WaypointConfig &from = waypoints_[memory.line], &to = waypoints_[memory.line + 1];
  const Eigen::Vector2d way = place_of(to) - place_of(from);
  const TrackErrors errors = track_errors(place_of(from), place_of(to), place);
  const double length_m = way.norm(), share = errors.along / length_m;
  const double aside_m = errors.cross + integral_gain_mps_ * memory.integral_s;
  Prescribed p;
  p.speed.value = to.speed_mps;
  p.yaw.value = std::atan2(way.y(), way.x()) - std::atan(aside_m / lookahead_m_);
  const double slant_m = std::hypot(aside_m, lookahead_m_);
  p.yaw.rate = lookahead_m_ * to.speed_mps * aside_m / (slant_m * slant_m * slant_m);
  p.depth_m = from.depth_m + std::clamp(share, 0.0, 1.0) * (to.depth_m - from.depth_m);
  if (share > 0 && share < 1) p.descent_mps = (to.depth_m - from.depth_m) / length_m * to.speed_mps;
  memory.integral_s += dt * lookahead_m_ * errors.cross / (slant_m * slant_m);
  return p;
}

double WaypointGuidance::planned_s() const {
  double sum_s = 0;
  for (std::size_t i = 1; i < waypoints_.size(); ++i)
    sum_s += distance_m(waypoints_[i - 1], waypoints_[i]) / waypoints_[i].speed_mps;
  return sum_s;
}

}  // namespace drydock::motion
