#include "hil/motion/vehicle/mission_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "estimators/frame/earth.hpp"
#include "hil/motion/bad_mission.hpp"

namespace drydock::motion {

namespace {

double propeller_gives_mps(const rig_config::VehicleConfig& vehicle) {
  return vehicle.propeller.advance_m * vehicle.propeller.limit_radps;
}

}  // namespace

MissionPlan::MissionPlan(const rig_config::MissionConfig& mission)
    : begin_{mission.latitude_rad, mission.longitude_rad, 0}, profile_(mission) {
  if (!mission.waypoints.empty()) guidance_.emplace(mission);
}

Eigen::Vector2d MissionPlan::north_east_m(const VehicleState& state) const {
  return frame::ned_offset(begin_, {state.latitude_rad, state.longitude_rad, 0}).head<2>();
}

Prescribed MissionPlan::at(double t, const VehicleState& state, GuidanceMemory& memory,
                           double dt) const {
  return guidance_ ? guidance_->wanted(north_east_m(state), memory, dt) : profile_.at(t);
}

std::optional<Passed> MissionPlan::pass(const VehicleState& state, GuidanceMemory& memory) const {
  return guidance_ ? guidance_->pass(north_east_m(state), memory) : std::nullopt;
}

double MissionPlan::planned_s() const {
  return guidance_ ? guidance_->planned_s() : profile_.lap_s();
}

void MissionPlan::check(const rig_config::MissionConfig& mission, const ocean::Ocean& ocean) const {
  if (guidance_) {
    check_lines(propeller_gives_mps(mission.vehicle.value()), ocean);
  } else {
    check_legs(mission, ocean);
  }
}

/// It follows the track by dead reckoning in steps of a second.
void MissionPlan::check_legs(const rig_config::MissionConfig& mission,
                             const ocean::Ocean& ocean) const {
  const double fastest = propeller_gives_mps(mission.vehicle.value());
  double latitude = mission.latitude_rad, longitude = mission.longitude_rad;
  for (int second = 0; second <= profile_.lap_s(); ++second) {
    const double t = second;
    const Prescribed plan = profile_.at(t);
    if (plan.speed.value > fastest)
      throw BadMission(profile_.path_at(t),
                       fmt::format("mission: after {:.0f} s the vehicle would need {:.2f} m/s, its "
                                   "propeller gives {:.2f}",
                                   t, plan.speed.value, fastest));
    const double bed_m = ocean.bed_depth_m(latitude, longitude);
    if (plan.depth_m >= bed_m)
      throw BadMission(
          profile_.path_at(t),
          fmt::format("mission: after {:.0f} s the vehicle would be {:.1f} m deep, at or below the "
                      "sea bed ({:.1f} m there)",
                      t, plan.depth_m, bed_m));
    const Eigen::Vector3d current = ocean.current_ned(plan.depth_m, t);
    const double level = std::sqrt(
        std::max(plan.speed.value * plan.speed.value - plan.descent_mps * plan.descent_mps, 0.0));
    latitude += (level * std::cos(plan.yaw.value) + current.x()) / frame::meridian_radius(latitude);
    longitude += (level * std::sin(plan.yaw.value) + current.y()) /
                 (frame::transverse_radius(latitude) * std::cos(latitude));
  }
}

void MissionPlan::check_lines(double fastest, const ocean::Ocean& ocean) const {
  constexpr int parts = 256;  // of a line, where the bed is looked at
  const auto& waypoints = guidance_->waypoints();
  for (std::size_t i = 1; i < waypoints.size(); ++i) {
    const auto &from = waypoints[i - 1], &to = waypoints[i];
    if (to.speed_mps > fastest)
      throw BadMission(
          fmt::format("/waypoint/{}", i),
          fmt::format("mission waypoint {}: the vehicle would need {:.2f} m/s, its propeller "
                      "gives {:.2f}",
                      i + 1, to.speed_mps, fastest));
    for (int part = 0; part <= parts; ++part) {
      const double share = static_cast<double>(part) / parts;
      const Eigen::Vector2d place = place_of(from) + share * (place_of(to) - place_of(from));
      const auto there = frame::at_ned_offset(begin_, {place.x(), place.y(), 0});
      const double depth_m = from.depth_m + share * (to.depth_m - from.depth_m);
      const double bed_m = ocean.bed_depth_m(there.latitude_rad, there.longitude_rad);
      if (depth_m >= bed_m)
        throw BadMission(fmt::format("/waypoint/{}", i),
                         fmt::format("mission waypoint {}: its line leads {:.1f} m deep, at or "
                                     "below the sea bed ({:.1f} m there)",
                                     i + 1, depth_m, bed_m));
    }
  }
}

}  // namespace drydock::motion
