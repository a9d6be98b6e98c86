#pragma once

#include <limits>

namespace drydock::motion {

/// The limits of a rudder, a plane or a propeller, in the unit of its value.
struct ActuatorLimits {
  double lower = 0, upper = 0;                            ///< stops
  double rate = std::numeric_limits<double>::infinity();  ///< per second, in both directions
  double lag_s = 0;                                       ///< time constant of the approach
};

/// Follows its command as a first-order lag with limited rate and stops: dx/dt = clamp((command -
/// x) / lag, +-rate).
class Actuator {
 public:
  explicit Actuator(const ActuatorLimits& limits, double value = 0);

  /// Advances by dt seconds; the command is held for that time. The solution is exact: two steps of
  /// dt/2 give the same result as one of dt.
  void step(double command, double dt);

  double value() const { return value_; }

 private:
  double decay(double dt);  ///< what is left of the way after dt seconds of lag

  ActuatorLimits limits_;
  double value_;
  double decay_dt_ = 0, decay_ = 1;  ///< the latest of decay()
};

}  // namespace drydock::motion
