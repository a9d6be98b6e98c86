#include "estimators/smoothing/tilt_smoother.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "estimators/smoothing/rts.hpp"
#include "estimators/smoothing/singer.hpp"

namespace drydock::smoothing {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using TiltStep = RtsStep<3>;

constexpr std::size_t least_tilts = 8, most_fitted = 10'000;
constexpr double first_tilt_factor = 4, last_tilt_factor = 1.05;  ///< factors that the search tries
constexpr double least_noise_rad = 1e-5;
constexpr double shortest_s = 0.2, longest_s = 20;  ///< that an angular acceleration lasts
constexpr double any_rate_radps = 1;
constexpr double gate_square = 25;  ///< beyond it a residual counts by its logarithm, as in (S12)

/// One of the two angles.
struct Axis {
  double Tilt::*angle, Tilt::*rate;
};

struct TiltMotion {
  double noise_rad, density, lasts_s;
};

/// The filter of one angle, its rate and its angular acceleration.
class TiltFilter {
 public:
  TiltFilter(const TiltMotion& motion, double first_rad)
      : motion_(motion), state_(first_rad, 0, 0) {
    const double sigma = 10 * motion.noise_rad;
    const double acceleration = singer_acceleration(motion.density, motion.lasts_s);
    p_ = Vector3d(sigma, any_rate_radps, acceleration).cwiseAbs2().asDiagonal();
  }

  /// Returns -2 ln of the likelihood of the angle.
  double take(double dt, double angle_rad, TiltStep& step) {
    const auto moved = singer_step(motion_.density, motion_.lasts_s, dt);
    state_ = moved.transition * state_;
    p_ = moved.transition * p_ * moved.transition.transpose() + moved.noise;
    step.transition = moved.transition;
    step.predicted = p_;
    const double residual = angle_rad - state_(0);
    const double variance = p_(0, 0) + motion_.noise_rad * motion_.noise_rad;
    const Vector3d gain = p_.col(0) / variance;
    step.correction = residual * gain;
    state_ += step.correction;
    p_ -= variance * gain * gain.transpose();
    step.filtered = p_;
    const double square = residual * residual / variance;
    return (square < gate_square ? square : gate_square * (1 + std::log(square / gate_square))) +
           std::log(variance);
  }

  const Vector3d& state() const { return state_; }

 private:
  TiltMotion motion_;
  Vector3d state_;
  Matrix3d p_;
};

/// Calls `after(step, state)` for each tilt; returns -2 ln of the likelihood of all.
template <class After>
double filter_tilts(std::span<const Tilt> tilts, const Axis& axis, const TiltMotion& motion,
                    After after) {
  TiltFilter filter(motion, tilts.front().*axis.angle);
  double cost = 0, before_s = tilts.front().time_s;
  for (const Tilt& tilt : tilts) {
    TiltStep step;
    cost += filter.take(std::max(0.0, tilt.time_s - before_s), tilt.*axis.angle, step);
    before_s = tilt.time_s;
    after(step, filter.state());
  }
  return cost;
}

double cost_of(std::span<const Tilt> tilts, const Axis& axis, const TiltMotion& motion) {
  return filter_tilts(tilts, axis, motion, [](const TiltStep&, const Vector3d&) {});
}

/// From fourth differences, which hardly see motion; their median does not mind a jump.
double first_noise(std::span<const Tilt> tilts, const Axis& axis) {
  constexpr double median_to_sigma = 1.4826, sum_of_squares = 70;
  std::vector<double> sizes;
  for (std::size_t i = 0; i + 4 < tilts.size(); ++i) {
    const auto at = [&](std::size_t k) { return tilts[i + k].*axis.angle; };
    sizes.push_back(std::abs(at(0) - 4 * at(1) + 6 * at(2) - 4 * at(3) + at(4)));
  }
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::ranges::nth_element(sizes, middle);
  return std::max(least_noise_rad, median_to_sigma * *middle / std::sqrt(sum_of_squares));
}

bool is_possible(const TiltMotion& motion) {
  return motion.noise_rad >= least_noise_rad && motion.lasts_s >= shortest_s &&
         motion.lasts_s <= longest_s && motion.density >= 1e-3 * least_noise_rad;
}

/// Turns one value at a time, as (S12). It begins with little motion: from too much of it the
/// search would take all noise for motion.
TiltMotion most_likely_motion(std::span<const Tilt> all, const Axis& axis) {
  const std::size_t count = std::min(all.size(), most_fitted);
  const auto tilts = all.subspan((all.size() - count) / 2, count);
  const double noise = first_noise(tilts, axis);
  TiltMotion motion{noise, noise, 2};
  double best = cost_of(tilts, axis, motion);
  const auto improve = [&](double TiltMotion::*knob, double by) {
    bool better = false;
    for (;;) {
      TiltMotion trial = motion;
      trial.*knob *= by;
      if (!is_possible(trial)) return better;
      const double cost = cost_of(tilts, axis, trial);
      if (!(cost < best)) return better;
      best = cost;
      motion = trial;
      better = true;
    }
  };
  double step = first_tilt_factor;
  while (step > last_tilt_factor) {
    for (auto knob : {&TiltMotion::density, &TiltMotion::lasts_s, &TiltMotion::noise_rad})
      if (!improve(knob, step)) improve(knob, 1 / step);
    step = std::sqrt(step);
  }
  return motion;
}

}  // namespace

std::vector<Tilt> smooth_tilts(std::vector<Tilt> tilts) {
  if (tilts.size() < least_tilts) return tilts;
  constexpr std::array axes{Axis{&Tilt::roll_rad, &Tilt::roll_radps},
                            Axis{&Tilt::pitch_rad, &Tilt::pitch_radps}};
  for (const Axis& axis : axes) {
    std::vector<TiltStep> steps;
    std::vector<Vector3d> states;
    steps.reserve(tilts.size());
    states.reserve(tilts.size());
    filter_tilts(tilts, axis, most_likely_motion(tilts, axis),
                 [&](const TiltStep& step, const Vector3d& state) {
                   steps.push_back(step);
                   states.push_back(state);
                 });
    const auto results = smooth<3>(std::span<const TiltStep>(steps));
    for (std::size_t i = 0; i < tilts.size(); ++i) {
      const Vector3d smoothed = states[i] + results[i].correction;
      tilts[i].*axis.angle = smoothed(0);
      tilts[i].*axis.rate = smoothed(1);
    }
  }
  return tilts;
}

}  // namespace drydock::smoothing
