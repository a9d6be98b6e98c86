#include <filesystem>

#include "drivers/measurement/units.hpp"
#include "rig_config/checks/checks.hpp"
#include "rig_config/toml/places_of.hpp"
#include "rig_config/toml/read_keys.hpp"
#include "rig_config/typed/build.hpp"

namespace drydock::rig_config {

namespace {

constexpr std::array leg_kinds{"straight", "turn",   "dive",           "s_path",
                               "spiral",   "zigzag", "turning_circle", "surface"};

LegConfig build_leg(const Node& table, double speed_before) {
  LegConfig leg;
  leg.kind = named<LegKind>(table, leg_kinds);
  leg.speed_mps = speed_before;
  read(table, "duration_s", leg.duration_s);
  read(table, "speed_mps", leg.speed_mps);
  read(table, "turn_deg", leg.turn_rad, units::degree);
  read(table, "roll_deg", leg.roll_rad, units::degree);
  read(table, "depth_change_m", leg.depth_change_m);
  read(table, "amplitude_deg", leg.amplitude_rad, units::degree);
  read(table, "period_s", leg.period_s);
  read(table, "rate_degps", leg.rate_radps, units::degree);
  read(table, "end_rate_degps", leg.end_rate_radps, units::degree);
  read(table, "rudder_deg", leg.rudder_rad, units::degree);
  read(table, "ramp_s", leg.ramp_s);
  return leg;
}

BallisticConfig build_ballistic(const Node& table) {
  BallisticConfig flight;
  read(table, "height_m", flight.height_m);
  read(table, "ground_height_m", flight.ground_height_m);
  read(table, "elevation_deg", flight.elevation_rad, units::degree);
  read(table, "ballistic_coefficient_kgm2", flight.ballistic_coefficient_kgm2);
  read(table, "roll_rate_degps", flight.roll_rate_radps, units::degree);
  read(table, "roll_deg", flight.roll_rad, units::degree);
  read(table, "spin_up_s", flight.spin_up_s);
  read(table, "angle_of_attack_deg", flight.angle_of_attack_rad, units::degree);
  read(table, "coning_hz", flight.coning_radps, 2 * std::numbers::pi);
  return flight;
}

WaypointConfig build_waypoint(const Node& table, const WaypointConfig& before) {
  WaypointConfig waypoint;
  waypoint.depth_m = before.depth_m;
  waypoint.speed_mps = before.speed_mps;
  read(table, "north_m", waypoint.north_m);
  read(table, "east_m", waypoint.east_m);
  read(table, "depth_m", waypoint.depth_m);
  read(table, "speed_mps", waypoint.speed_mps);
  read(table, "radius_m", waypoint.radius_m);
  return waypoint;
}

GuidanceConfig build_guidance(const Node& table) {
  GuidanceConfig guidance;
  read(table, "lookahead_m", guidance.lookahead_m);
  read(table, "integral_gain_mps", guidance.integral_gain_mps);
  return guidance;
}

SteeringConfig build_steering(const Node& table, const std::string& file) {
  SteeringConfig steering;
  read(table, "from", steering.from);
  read(table, "listen", steering.listen);
  if (const Node* command = table.find("command"))
    for (const Node& word : command->items) steering.command.push_back(word.text);
  steering.folder = std::filesystem::path(file).parent_path().string();
  read(table, "step_s", steering.step_s);
  read(table, "answer_within_s", steering.answer_within_s);
  read(table, "truth", steering.truth);
  return steering;
}

}  // namespace

MissionConfig build_mission(const Node& root, const std::string& file) {
  MissionConfig mission;
  mission.places = places_of(root, file);
  const Node& table = *root.find("mission");
  read(table, "latitude_deg", mission.latitude_rad, units::degree);
  read(table, "longitude_deg", mission.longitude_rad, units::degree);
  read(table, "depth_m", mission.depth_m);
  read(table, "heading_deg", mission.heading_rad, units::degree);
  read(table, "speed_mps", mission.speed_mps);
  read(table, "pivot_m", mission.pivot_m);
  read(table, "sideslip_lag_s", mission.sideslip_lag_s);
  if (const Node* ocean = root.find("ocean")) mission.ocean = build_ocean(*ocean, file);
  double speed_mps = mission.speed_mps;
  for_each_table(root, "leg", [&](const Node& leg, std::size_t) {
    mission.legs.push_back(build_leg(leg, speed_mps));
    speed_mps = mission.legs.back().speed_mps;
  });
  WaypointConfig before{.depth_m = mission.depth_m, .speed_mps = mission.speed_mps};
  for_each_table(root, "waypoint", [&](const Node& waypoint, std::size_t) {
    before = mission.waypoints.emplace_back(build_waypoint(waypoint, before));
  });
  if (const Node* guidance = root.find("guidance")) mission.guidance = build_guidance(*guidance);
  if (const Node* ballistic = root.find("ballistic")) {
    mission.ballistic = build_ballistic(*ballistic);
    read(*ballistic, "speed_mps", mission.speed_mps);
  }
  if (const Node* track = root.find("track")) {
    mission.track = TrackConfig{beside(file, track->find("file")->text)};
    mission.files.push_back(mission.track->file);
  }
  if (const Node* steering = root.find("steering"))
    mission.steering = build_steering(*steering, file);
  mission.faults = build_faults(root, file);
  return mission;
}

}  // namespace drydock::rig_config
