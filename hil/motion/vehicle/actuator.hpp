#pragma once

#include <limits>

namespace drydock::motion {

/// What keeps a rudder, a plane or a propeller from being where it is told. Units of its value.
struct ActuatorLimits {
  double lower = 0, upper = 0;                            ///< stops
  double rate = std::numeric_limits<double>::infinity();  ///< per second, both ways
  double lag_s = 0;                                       ///< time constant of the approach
};

/// Follows its command as a first-order lag that can move no faster than its rate and no further
/// than its stops: dx/dt = clamp((command - x) / lag, +-rate).
class Actuator {
 public:
  explicit Actuator(const ActuatorLimits& limits, double value = 0);

  /// Goes on by dt seconds towards a command held for that time. The solution is exact: two steps
  /// of dt/2 end where one of dt does.
  void step(double command, double dt);

  double value() const { return value_; }

 private:
  ActuatorLimits limits_;
  double value_;
};

}  // namespace drydock::motion
