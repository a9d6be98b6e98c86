#pragma once

#include <algorithm>

/// Polynomials that rise from 0 to 1 for x from 0 to 1 and are flat at both ends.
namespace drydock::motion {

/// Quintic: first and second derivative vanish at both ends.
constexpr double quintic(double x) { return x * x * x * (10 + x * (6 * x - 15)); }
constexpr double quintic_rate(double x) { return 30 * x * x * (1 - x) * (1 - x); }
constexpr double quintic_integral(double x) { return x * x * x * x * (2.5 + x * (x - 3)); }

/// Septic: the third derivative vanishes as well.
constexpr double septic(double x) { return x * x * x * x * (35 + x * (x * (70 - 20 * x) - 84)); }
constexpr double septic_rate(double x) {
  const double y = x * (1 - x);
  return 140 * y * y * y;
}
constexpr double septic_acceleration(double x) {
  const double y = x * (1 - x);
  return 420 * y * y * (1 - 2 * x);
}

/// 0 -> 1 -> 0 over [0, duration]: quintic ramps of length `ramp` at both ends, 1 between them.
struct Window {
  double duration, ramp;

  constexpr double value(double t) const {
    return quintic(std::min({t / ramp, (duration - t) / ramp, 1.0}));
  }
  constexpr double rate(double t) const {
    if (t < ramp) return quintic_rate(t / ramp) / ramp;
    if (t > duration - ramp) return -quintic_rate((duration - t) / ramp) / ramp;
    return 0;
  }
  constexpr double integral(double t) const {
    if (t < ramp) return ramp * quintic_integral(t / ramp);
    if (t > duration - ramp) return area() - ramp * quintic_integral((duration - t) / ramp);
    return ramp / 2 + (t - ramp);
  }
  constexpr double area() const { return duration - ramp; }
};

}  // namespace drydock::motion
