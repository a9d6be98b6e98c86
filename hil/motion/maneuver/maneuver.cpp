#include "hil/motion/maneuver/maneuver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "drivers/measurement/units.hpp"

namespace drydock::motion {

namespace {

using namespace element;

constexpr std::array<std::string_view, 4> names{"turning-circle", "zigzag", "spiral", "dive"};

Command ahead(double speed_mps) { return {0, 0, 0, speed_mps}; }

Steering turning_circle(double speed, double rudder) {
  return [=](double t, const hydrodynamics::State& state) -> std::optional<Command> {
    if (std::abs(state[yaw]) > 540 * units::degree) return {};
    Command command = ahead(speed);
    if (t >= execute_s) command.delta_r = rudder;
    return command;
  };
}

Steering zigzag(double speed, double rudder, double reverse_at) {
  constexpr int reversals = 5;
  return [=, side = rudder < 0 ? -1.0 : 1.0, left = reversals + 1](
             double t, const hydrodynamics::State& state) mutable -> std::optional<Command> {
    Command command = ahead(speed);
    if (t < execute_s) return command;
    if (-side * state[yaw] >= reverse_at) {  // positive rudder turns to port: the heading falls
      side = -side;
      if (--left == 0) return {};
    }
    command.delta_r = side * std::abs(rudder);
    return command;
  };
}

std::vector<double> spiral_steps(double limit) {
  constexpr std::array parts{1.0, 0.75, 0.5, 0.25, 0.125, 0.0};
  std::vector<double> there;
  there.reserve(2 * parts.size());
  for (const double part : parts) there.push_back(part * limit);
  for (auto part = std::next(parts.rbegin()); part != parts.rend(); ++part)
    there.push_back(-*part * limit);
  std::vector<double> steps = there;
  steps.insert(steps.end(), std::next(there.rbegin()), there.rend());
  return steps;
}

Steering spiral(double speed, double limit) {
  constexpr double look_each_s = 30, longest_s = 600, settled_radps = 2e-4 * units::degree;
  return [=, steps = spiral_steps(limit), step = std::size_t{0}, since = execute_s,
          looked_at = execute_s, before_r = 0.0](
             double t, const hydrodynamics::State& state) mutable -> std::optional<Command> {
    Command command = ahead(speed);
    if (t < execute_s) return command;
    if (t - looked_at >= look_each_s) {
      const bool stands = std::abs(state[r] - before_r) < settled_radps;
      looked_at = t;
      before_r = state[r];
      if (stands || t - since > longest_s) {
        since = t;
        if (++step == steps.size()) return {};
      }
    }
    command.delta_r = steps[step];
    return command;
  };
}

Steering dive(double speed, double planes, double reverse_at) {
  return [=, reversed = false](
             double t, const hydrodynamics::State& state) mutable -> std::optional<Command> {
    Command command = ahead(speed);
    if (t < execute_s) return command;
    reversed = reversed || -state[pitch] >= reverse_at;
    if (reversed && descent_rate(state) <= 0) return {};
    command.delta_s = reversed ? -planes : planes;  // positive stern planes: nose down
    return command;
  };
}

}  // namespace

std::string_view to_string(ManeuverKind kind) { return names[static_cast<std::size_t>(kind)]; }

std::optional<ManeuverKind> maneuver_kind(std::string_view name) {
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) return {};
  return static_cast<ManeuverKind>(found - names.begin());
}

std::optional<std::string> refusal(const rig_config::VehicleConfig& vehicle, const Maneuver& m) {
  const double fastest = fastest_mps(vehicle);
  if (!(m.speed_mps > 0 && m.speed_mps <= fastest))
    return fmt::format(
        "a speed of {:.4g} m/s; allowed: above 0, up to {:.4g} m/s, the propeller's "
        "limit",
        m.speed_mps, fastest);
  if (!m.deflection_rad) return {};
  const bool dives = m.kind == ManeuverKind::dive;
  const double stop = dives ? vehicle.stern_planes.limit_rad : vehicle.rudder.limit_rad;
  const double angle = dives ? *m.deflection_rad : std::abs(*m.deflection_rad);
  if (angle > 0 && angle <= stop) return {};
  return fmt::format("a deflection of {:.4g} deg; allowed: {}, up to the stop at {:.4g} deg",
                     *m.deflection_rad / units::degree,
                     dives ? "above 0 (nose down)" : "to either side, not 0", stop / units::degree);
}

double fastest_mps(const rig_config::VehicleConfig& vehicle) {
  return vehicle.propeller.limit_radps * vehicle.propeller.advance_m;
}

Track sail(const rig_config::VehicleConfig& vehicle, const Maneuver& m) {
  constexpr double usual_zigzag = 10 * units::degree, usual_dive = 5 * units::degree;
  constexpr double limit_s = 3600, spiral_limit_s = 4 * 3600;
  switch (m.kind) {
    case ManeuverKind::turning_circle:
      return sail(vehicle, m.speed_mps, limit_s,
                  turning_circle(m.speed_mps, m.deflection_rad.value_or(vehicle.rudder.limit_rad)));
    case ManeuverKind::zigzag:
      return sail(vehicle, m.speed_mps, limit_s,
                  zigzag(m.speed_mps, m.deflection_rad.value_or(usual_zigzag), m.switch_rad));
    case ManeuverKind::spiral:
      return sail(vehicle, m.speed_mps, spiral_limit_s,
                  spiral(m.speed_mps, m.deflection_rad.value_or(vehicle.rudder.limit_rad)));
    case ManeuverKind::dive: break;
  }
  return sail(vehicle, m.speed_mps, limit_s,
              dive(m.speed_mps, m.deflection_rad.value_or(usual_dive), m.switch_rad));
}

}  // namespace drydock::motion
