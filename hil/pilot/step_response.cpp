#include "hil/pilot/step_response.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace drydock::pilot {

namespace {

using rig_config::LegConfig;
using rig_config::LegKind;

enum class Effect : std::uint8_t { none, step, other };

Effect on_heading(const LegConfig& leg, double) {
  switch (leg.kind) {
    case LegKind::turn: return Effect::step;
    case LegKind::s_path:
    case LegKind::spiral:
    case LegKind::zigzag:
    case LegKind::turning_circle: return Effect::other;
    default: return Effect::none;
  }
}

Effect on_depth(const LegConfig& leg, double) {
  return leg.kind == LegKind::dive || leg.kind == LegKind::surface ? Effect::step : Effect::none;
}

Effect on_speed(const LegConfig& leg, double speed_before) {
  return leg.speed_mps == speed_before ? Effect::none : Effect::step;
}

struct Quantity {
  const char *name, *unit;
  LoopCurve LoopTrace::*curve;
  Effect (*effect)(const LegConfig& leg, double speed_before);
};

constexpr std::array quantities{Quantity{"heading", "deg", &LoopTrace::heading_deg, on_heading},
                                Quantity{"depth", "m", &LoopTrace::depth_m, on_depth},
                                Quantity{"speed", "m/s", &LoopTrace::speed_mps, on_speed}};

/// A step and how long the legs after it leave the quantity alone.
struct Window {
  double begins_s, leg_ends_s, ends_s;
};

std::vector<Window> windows(const rig_config::MissionConfig& mission, const Quantity& quantity) {
  std::vector<Window> found;
  double t = 0, speed = mission.speed_mps;
  bool held = false;
  for (const LegConfig& leg : mission.legs) {
    const Effect effect = quantity.effect(leg, speed);
    if (effect != Effect::none) held = effect == Effect::step;
    if (effect == Effect::step) found.push_back({t, t + leg.duration_s, t});
    t += leg.duration_s;
    speed = leg.speed_mps;
    if (held) found.back().ends_s = t;
  }
  return found;
}

double mean(const std::vector<double>& values, std::size_t from, std::size_t to) {
  const auto at = [&](std::size_t i) { return values.begin() + static_cast<std::ptrdiff_t>(i); };
  return std::accumulate(at(from), at(to), 0.0) / static_cast<double>(to - from);
}

/// Empty: the trace ends before the leg does.
std::optional<StepResponse> response(const LoopTrace& trace, const Quantity& quantity,
                                     const Window& window) {
  constexpr double longest_mean_s = 10, shortest_mean_s = 2;
  const auto index = [&](double t) {
    constexpr double rounding_s = 1e-6;
    const auto found = std::ranges::lower_bound(trace.t_s, t - rounding_s);
    return static_cast<std::size_t>(found - trace.t_s.begin());
  };
  const LoopCurve& curve = trace.*quantity.curve;
  const std::size_t begin = index(window.begins_s), leg_end = index(window.leg_ends_s),
                    end = index(window.ends_s);
  if (leg_end >= trace.t_s.size()) return {};
  StepResponse answer{quantity.name,
                      quantity.unit,
                      window.begins_s,
                      curve.wanted[begin],
                      curve.wanted[leg_end],
                      0,
                      {},
                      {}};
  const double change = answer.to - answer.from;
  if (change == 0) return {};
  std::size_t settled = begin;
  for (std::size_t i = begin; i < end; ++i) {
    const double beyond = curve.is[i] - answer.to;
    answer.overshoot = std::max(answer.overshoot, std::copysign(1.0, change) * beyond);
    if (std::abs(beyond) > settled_within * std::abs(change)) settled = i + 1;
  }
  if (settled < end) answer.settling_s = trace.t_s[settled] - window.begins_s;
  const double last_s = trace.t_s[end - 1];
  const double mean_s = std::min(longest_mean_s, (last_s - window.leg_ends_s) / 2);
  if (mean_s >= shortest_mean_s)
    answer.steady_error = mean(curve.is, index(last_s - mean_s), end) - answer.to;
  return answer;
}

}  // namespace

std::vector<StepResponse> step_responses(const rig_config::MissionConfig& mission,
                                         const LoopTrace& trace) {
  std::vector<StepResponse> all;
  for (const Quantity& quantity : quantities)
    for (const Window& window : windows(mission, quantity))
      if (auto answer = response(trace, quantity, window)) all.push_back(std::move(*answer));
  return all;
}

}  // namespace drydock::pilot
