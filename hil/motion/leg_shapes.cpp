#include "hil/motion/leg_shapes.hpp"

#include <algorithm>
#include <cmath>

namespace drydock::motion {

namespace {

using rig_config::LegConfig;

constexpr double quintic_steepest = 1.875;  // quintic_rate(1/2)

/// A value that rises from 0 to `step` between `from` and `from` + `duration`, and its integral.
struct Transition {
  double step, from, duration;

  double x(double t) const { return std::clamp((t - from) / duration, 0.0, 1.0); }
  Varying value(double t) const {
    return {step * quintic(x(t)), step * quintic_rate(x(t)) / duration};
  }
  Varying integral(double t) const {
    const double after = std::max(t - from - duration, 0.0);
    return {step * (duration * quintic_integral(x(t)) + after), step * quintic(x(t))};
  }
};

double turning_s(const LegConfig& leg, double angle_rad) {
  return quintic_steepest * std::abs(angle_rad / leg.rate_radps);
}

}  // namespace

Varying spiral(const LegConfig& leg, const Window& window, double t) {
  const double change = leg.end_rate_radps - leg.rate_radps;
  Varying turned;
  for (const Transition& part :
       {Transition{leg.rate_radps, 0, window.ramp},
        Transition{change, window.ramp, window.duration - 2 * window.ramp},
        Transition{-leg.end_rate_radps, window.duration - window.ramp, window.ramp}}) {
    if (part.duration <= 0) continue;
    const Varying more = part.integral(t);
    turned.value += more.value;
    turned.rate += more.rate;
  }
  return turned;
}

Varying zigzag(const LegConfig& leg, double t) {
  const double half = leg.period_s / 2, amplitude = leg.amplitude_rad;
  const auto halves = std::lround(std::floor(leg.duration_s / half));
  const double back_s = leg.duration_s - turning_s(leg, amplitude);
  const auto now = std::min(std::lround(std::floor(t / half)), halves - 1);
  const double side = now % 2 == 0 ? amplitude : -amplitude;
  const double before = now == 0 ? 0 : -side, step = side - before;
  Varying heading =
      Transition{step, static_cast<double>(now) * half, turning_s(leg, step)}.value(t);
  heading.value += before;
  const Varying back = Transition{-side, back_s, turning_s(leg, amplitude)}.value(t);
  return {heading.value + back.value, heading.rate + back.rate};
}

bool turns_fit(const LegConfig& leg) {
  if (!(leg.period_s > 0) || leg.rate_radps == 0 || leg.duration_s < leg.period_s) return false;
  const double half = leg.period_s / 2;
  const double last_s = leg.duration_s - half * (std::floor(leg.duration_s / half) - 1);
  const double over = turning_s(leg, 2 * leg.amplitude_rad);
  return over <= half && over + turning_s(leg, leg.amplitude_rad) <= last_s;
}

}  // namespace drydock::motion
