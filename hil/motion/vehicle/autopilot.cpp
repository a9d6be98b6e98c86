#include "hil/motion/vehicle/autopilot.hpp"

#include <algorithm>
#include <cmath>

#include "estimators/frame/attitude.hpp"

namespace drydock::motion {

namespace {

constexpr double slowest_flow_mps = 0.5;  // below this the surfaces have almost no effect

}  // namespace

double Integral::act(double proportional, double error_rate, double lower, double upper,
                     double dt) {
  const double wanted = proportional + value_;
  const double output = std::clamp(wanted, lower, upper);
  const bool would_go_further =
      (wanted > upper && error_rate > 0) || (wanted < lower && error_rate < 0);
  if (!would_go_further) value_ += error_rate * dt;
  return output;
}

Autopilot::Autopilot(const rig_config::VehicleConfig& vehicle, const AutopilotGains& gains)
    : gains_(gains),
      length_m_(vehicle.length_m),
      rudder_limit_(vehicle.rudder.limit_rad),
      planes_limit_(vehicle.stern_planes.limit_rad),
      fastest_mps_(vehicle.propeller.advance_m * vehicle.propeller.limit_radps) {}

Command Autopilot::steer(const Prescribed& wanted, const VehicleState& s, AutopilotMemory& memory,
                         double dt) const {
  const frame::Euler attitude = frame::euler(s.body_to_ned);
  const double u = s.velocity[0], q = s.velocity[4], r = s.velocity[5];
  const double sin_roll = std::sin(attitude.roll), cos_roll = std::cos(attitude.roll);
  const double rate_of_turn = (q * sin_roll + r * cos_roll) / std::cos(attitude.pitch);
  const double lengths_ps = std::max(u, slowest_flow_mps) / length_m_;

  Command command;
  if (wanted.rudder_rad) {
    memory.turned_rad = frame::wrap_pi(attitude.yaw - wanted.yaw.value);
    command.delta_r = *wanted.rudder_rad;
  } else {
    command.delta_r = rudder(wanted, attitude.yaw, rate_of_turn, lengths_ps, memory, dt);
  }
  command.delta_s = stern_planes(wanted, -s.height_m, attitude.pitch, q * cos_roll - r * sin_roll,
                                 lengths_ps, memory, dt);
  const double slow = wanted.speed.value - u;
  command.speed_mps =
      memory.speed.act(wanted.speed.value + gains_.speed * slow,
                       gains_.speed_integral * lengths_ps * slow, 0, fastest_mps_, dt);
  return command;
}

// Positive rudder turns to port.
double Autopilot::rudder(const Prescribed& wanted, double heading, double rate_of_turn,
                         double lengths_ps, AutopilotMemory& memory, double dt) const {
  const double error = frame::wrap_pi(wanted.yaw.value + memory.turned_rad - heading);
  const double slow = (wanted.yaw.rate - rate_of_turn) / lengths_ps;
  return -memory.heading.act(gains_.heading * error + gains_.rate_of_turn * slow,
                             gains_.heading_integral * lengths_ps * error, -rudder_limit_,
                             rudder_limit_, dt);
}

// The depth law sets a pitch, and the pitch law sets the planes. Positive planes push the bow down.
double Autopilot::stern_planes(const Prescribed& wanted, double depth, double pitch,
                               double pitch_rate, double lengths_ps, AutopilotMemory& memory,
                               double dt) const {
  const double flow = lengths_ps * length_m_, high = wanted.depth_m - depth;
  const double steepest = steepest_sine * flow;
  const double descent = memory.depth.act(wanted.descent_mps + gains_.depth * lengths_ps * high,
                                          gains_.depth_integral * lengths_ps * lengths_ps * high,
                                          -steepest, steepest, dt);
  const double error = -std::asin(descent / flow) - pitch;
  return -memory.pitch.act(gains_.pitch * error - gains_.pitch_rate * pitch_rate / lengths_ps,
                           gains_.pitch_integral * lengths_ps * error, -planes_limit_,
                           planes_limit_, dt);
}

}  // namespace drydock::motion
