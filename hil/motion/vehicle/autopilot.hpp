#pragma once

#include "hil/motion/vehicle/actuators.hpp"
#include "hil/motion/vehicle/vehicle_motion.hpp"
#include "hil/motion/waypoint_guidance.hpp"

/// Autopilots for heading, depth and speed. They use the true state. Equation numbers are those of
/// docs/world/vehicle.md.
namespace drydock::motion {

/// The integral part of a proportional-integral law. It is held while the output is at a stop and
/// the error would push it further.
class Integral {
 public:
  /// Returns `proportional` plus the integral, within the stops, and then updates the integral.
  double act(double proportional, double error_rate, double lower, double upper, double dt);

 private:
  double value_ = 0;
};

/// The memory of the autopilots from step to step.
struct AutopilotMemory {
  Integral heading, pitch, depth, speed;
  GuidanceMemory guidance;  ///< between waypoints
  double turned_rad = 0;    ///< by turning circles, in addition to the headings of the legs
};

/// The gains apply to the prime system, in which time is measured in lengths over speed. They are
/// the same for every speed.
struct AutopilotGains {
  double heading = 1, heading_integral = 0.1, rate_of_turn = 0.57;
  double pitch = 1.5, pitch_integral = 0.25, pitch_rate = 0.35;
  double depth = 0.08, depth_integral = 0.0016;
  double speed = 2, speed_integral = 0.1;
};

class Autopilot {
 public:
  explicit Autopilot(const rig_config::VehicleConfig& vehicle, const AutopilotGains& gains = {});

  /// Eq. (6) to (9): the commands to rudder, stern planes and propeller for the next dt seconds.
  Command steer(const Prescribed& wanted, const VehicleState& state, AutopilotMemory& memory,
                double dt) const;

  static constexpr double steepest_sine = 0.5;  ///< sine of the steepest pitch: 30 deg

 private:
  double rudder(const Prescribed& wanted, double heading, double rate_of_turn, double lengths_ps,
                AutopilotMemory& memory, double dt) const;
  double stern_planes(const Prescribed& wanted, double depth, double pitch, double pitch_rate,
                      double lengths_ps, AutopilotMemory& memory, double dt) const;

  AutopilotGains gains_;
  double length_m_, rudder_limit_, planes_limit_, fastest_mps_;
};

}  // namespace drydock::motion
