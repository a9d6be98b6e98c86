#include "hil/motion/vehicle/actuator.hpp"

#include <algorithm>
#include <cmath>

namespace drydock::motion {

Actuator::Actuator(const ActuatorLimits& limits, double value)
    : limits_(limits), value_(std::clamp(value, limits.lower, limits.upper)) {}

void Actuator::step(double command, double dt) {
  const double target = std::clamp(command, limits_.lower, limits_.upper);
  const double way = target - value_;
  // Beyond `near` the lag asks for more than the rate allows. So the motion is first linear, then
  // exponential.
  const double near = limits_.lag_s > 0 ? limits_.rate * limits_.lag_s : 0;
  double left = std::abs(way);
  if (left > near) {
    const double slewing_s = (left - near) / limits_.rate;
    left = slewing_s <= dt ? near : left - limits_.rate * dt;
    dt = std::max(0.0, dt - slewing_s);
  }
  if (left <= near) left = limits_.lag_s > 0 ? left * decay(dt) : 0;
  value_ = target - std::copysign(left, way);
}

/// Steps are mostly of one length.
double Actuator::decay(double dt) {
  if (dt != decay_dt_) {
    decay_dt_ = dt;
    decay_ = std::exp(-dt / limits_.lag_s);
  }
  return decay_;
}

}  // namespace drydock::motion
