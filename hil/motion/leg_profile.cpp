#include "hil/motion/leg_profile.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "hil/motion/bad_mission.hpp"
#include "hil/motion/leg_shapes.hpp"
#include "hil/motion/smooth_step.hpp"

namespace drydock::motion {
namespace {

using rig_config::LegConfig;
using rig_config::LegKind;

constexpr double longest_ramp_s = 10;
constexpr double steepest_sine = 0.8660254037844386;  // pitch of 60 deg
constexpr double steepest_sailed_sine = 0.5;          // 30 deg, see autopilot.hpp

Window window_of(const LegConfig& leg) {
  if (leg.ramp_s > 0) return {leg.duration_s, leg.ramp_s};
  return {leg.duration_s, std::min(longest_ramp_s, leg.duration_s / 4)};
}

/// The progress of a leg from 0 to 1, and its time derivatives.
struct Progress {
  double value, rate, acceleration;
};

Progress ramped(const Window& window, double t) {
  const double area = window.area();
  return {window.integral(t) / area, window.value(t) / area, window.rate(t) / area};
}

Progress of_speed(const LegConfig& leg, double t) {
  if (leg.ramp_s > 0) return ramped(window_of(leg), t);
  const double x = t / leg.duration_s;
  return {quintic(x), quintic_rate(x) / leg.duration_s, 0};
}

Progress of_depth(const LegConfig& leg, double t) {
  if (leg.ramp_s > 0) return ramped(window_of(leg), t);
  const double x = t / leg.duration_s, over_duration = 1 / leg.duration_s;
  return {septic(x), septic_rate(x) * over_duration,
          septic_acceleration(x) * over_duration * over_duration};
}

[[noreturn]] void refuse(std::size_t leg, const std::string& key, const std::string& why) {
  throw BadMission("/leg/" + std::to_string(leg) + "/" + key,
                   "mission leg " + std::to_string(leg + 1) + ": " + why);
}

void check(std::size_t number, const LegConfig& leg, double speed_before, double depth_before,
           const rig_config::MissionConfig& mission) {
  if (!(leg.duration_s > 0)) refuse(number, "duration_s", "duration_s must be above 0");
  if (leg.speed_mps < 0) refuse(number, "speed_mps", "speed_mps must not be negative");
  if (2 * leg.ramp_s > leg.duration_s)
    refuse(number, "ramp_s", "two ramps last longer than the leg");
  if (leg.kind == LegKind::s_path && !(leg.period_s > 0)) {
    refuse(number, "period_s", "an s_path needs a period_s above 0");
  }
  if (leg.kind == LegKind::zigzag && !turns_fit(leg)) {
    refuse(number, "rate_degps",
           "this zigzag needs a rate_degps that turns it in half a period_s, and two of these");
  }
  if (leg.kind == LegKind::turning_circle && !mission.vehicle) {
    refuse(number, "kind", "a turning_circle needs a vehicle with a rudder");
  }
  if (leg.kind != LegKind::dive && leg.kind != LegKind::surface) return;
  const char* const depth_key = leg.kind == LegKind::dive ? "depth_change_m" : "kind";
  const double steepest = mission.vehicle ? steepest_sailed_sine : steepest_sine;
  const double steepest_sink =
      std::abs(leg.depth_change_m) * of_depth(leg, leg.duration_s / 2).rate;
  if (steepest_sink > steepest * std::min(speed_before, leg.speed_mps)) {
    refuse(number, depth_key,
           fmt::format("this dive needs a pitch above {} deg; allow more time, speed or less depth",
                       mission.vehicle ? 30 : 60));
  }
  if (depth_before + leg.depth_change_m < 0)
    refuse(number, depth_key, "the dive ends above the surface");
}

void add_turn(const LegConfig& leg, double t, Prescribed& p) {
  const Window window = window_of(leg);
  const double rate = leg.turn_rad / window.area();
  p.yaw.value += rate * window.integral(t);
  p.yaw.rate = rate * window.value(t);
  p.roll = {leg.roll_rad * window.value(t), leg.roll_rad * window.rate(t)};
}

void turn_by(const Varying& turned, Prescribed& p) {
  p.yaw.value += turned.value;
  p.yaw.rate = turned.rate;
}

void add_s_path(const LegConfig& leg, double t, Prescribed& p) {
  const Window window = window_of(leg);
  const double omega = 2 * std::numbers::pi / leg.period_s;
  const double wave = leg.amplitude_rad * std::sin(omega * t);
  p.yaw.value += wave * window.value(t);
  p.yaw.rate =
      wave * window.rate(t) + leg.amplitude_rad * omega * std::cos(omega * t) * window.value(t);
}

void add_dive(const LegConfig& leg, double t, Prescribed& p) {
  const Progress progress = of_depth(leg, t);
  const double sink = leg.depth_change_m * progress.rate;
  const double sink_rate = leg.depth_change_m * progress.acceleration;
  p.depth_m += leg.depth_change_m * progress.value;
  p.descent_mps = sink;
  const double u = p.speed.value;
  if (u <= 0) return;  // a checked dive does not change depth at rest
  const double sine = -sink / u;
  const double sine_rate = -(sink_rate * u - sink * p.speed.rate) / (u * u);
  p.pitch = {std::asin(sine), sine_rate / std::sqrt(1 - sine * sine)};
}

}  // namespace

MissionProfile::MissionProfile(const rig_config::MissionConfig& mission) {
  begin_.speed.value = mission.speed_mps;
  begin_.yaw.value = mission.heading_rad;
  begin_.depth_m = mission.depth_m;
  if (mission.speed_mps < 0)
    throw BadMission("/mission/speed_mps", "mission: speed_mps must not be negative");
  end_ = begin_;
  for (std::size_t i = 0; i < mission.legs.size(); ++i) {
    LegConfig leg = mission.legs[i];
    if (leg.kind == LegKind::surface) leg.depth_change_m = -end_.depth_m;
    check(i, leg, end_.speed.value, end_.depth_m, mission);
    add(leg);
  }
  // In later laps, the first leg begins with the last leg's speed.
  if (!legs_.empty()) check(0, legs_[0].config, end_.speed.value, begin_.depth_m, mission);
}

void MissionProfile::add(const LegConfig& leg) {
  legs_.push_back({leg, lap_s_, end_.speed.value, end_.yaw.value, end_.depth_m});
  lap_s_ += leg.duration_s;
  end_.speed.value = leg.speed_mps;
  if (leg.kind == LegKind::turn) end_.yaw.value += leg.turn_rad;
  if (leg.kind == LegKind::spiral)
    end_.yaw.value += spiral(leg, window_of(leg), leg.duration_s).value;
  end_.depth_m += leg.depth_change_m;
}

std::string MissionProfile::path_at(double t) const {
  if (legs_.empty()) return "/mission/depth_m";
  const auto after = std::upper_bound(legs_.begin() + 1, legs_.end(), t,
                                      [](double x, const Leg& leg) { return x < leg.begins_s; });
  return "/leg/" + std::to_string(after - legs_.begin() - 1);
}

Prescribed MissionProfile::at(double t) const {
  if (legs_.empty() || t <= 0) return begin_;
  const double lap = std::floor(t / lap_s_);
  const double in_lap = t - lap * lap_s_;
  const auto after = std::upper_bound(legs_.begin() + 1, legs_.end(), in_lap,
                                      [](double x, const Leg& leg) { return x < leg.begins_s; });
  const Leg& leg = *(after - 1);
  const double in_leg = std::min(in_lap - leg.begins_s, leg.config.duration_s);

  const bool follows_a_lap = &leg == &legs_.front() && lap > 0;
  const double speed_before = follows_a_lap ? end_.speed.value : leg.speed_before;
  const double gain = leg.config.speed_mps - speed_before;
  const Progress progress = of_speed(leg.config, in_leg);

  Prescribed p;
  p.speed = {speed_before + gain * progress.value, gain * progress.rate};
  p.yaw.value = leg.yaw_before + lap * (end_.yaw.value - begin_.yaw.value);
  p.depth_m = leg.depth_before + lap * (end_.depth_m - begin_.depth_m);
  switch (leg.config.kind) {
    case LegKind::straight: break;
    case LegKind::turn: add_turn(leg.config, in_leg, p); break;
    case LegKind::dive: add_dive(leg.config, in_leg, p); break;
    case LegKind::s_path: add_s_path(leg.config, in_leg, p); break;
    case LegKind::spiral: turn_by(spiral(leg.config, window_of(leg.config), in_leg), p); break;
    case LegKind::zigzag: turn_by(zigzag(leg.config, in_leg), p); break;
    case LegKind::turning_circle: p.rudder_rad = leg.config.rudder_rad; break;
    case LegKind::surface: add_dive(leg.config, in_leg, p); break;
  }
  return p;
}

}  // namespace drydock::motion
