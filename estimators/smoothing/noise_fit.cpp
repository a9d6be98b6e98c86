#include "estimators/smoothing/noise_fit.hpp"

#include <algorithm>
#include <cmath>

#include "estimators/smoothing/level_smoother.hpp"

namespace drydock::smoothing {
namespace {

constexpr std::size_t most_readings = 40'000;
constexpr std::size_t motion_knobs = 4;  ///< of the velocity and the turn: density and correlation
constexpr double first_step = 4, last_step = 1.02;  ///< factors that the search tries
constexpr double largest_change = 1e3;              ///< of the motion, either way
constexpr double longest_change = 10;               ///< of its correlation times, either way
/// A sensor's noise is within these of its first guess: a motion that explains every wiggle would
/// else leave the sensor none.
constexpr double least_noise = 0.05, largest_noise = 1e3;

Dive middle_of(const Dive& dive) {
  Dive part{{}, dive.tilts, {}};
  const std::size_t count = std::min(dive.readings.size(), most_readings);
  const auto first =
      dive.readings.begin() + static_cast<std::ptrdiff_t>((dive.readings.size() - count) / 2);
  part.readings.assign(first, first + static_cast<std::ptrdiff_t>(count));
  return part;
}

/// The dive and the options under trial: motion first, then each unstated sensor.
class Trial {
 public:
  Trial(const Dive& dive, const LevelOptions& options, const std::vector<UnstatedNoise>& unstated)
      : dive_(middle_of(dive)),
        options_(options),
        unstated_(unstated),
        factors_(unstated.size(), 1) {
    if (dive_.readings.size() < dive.readings.size())
      options_.start = level_start(dive_, options.start.position);
  }

  std::size_t knobs() const { return motion_knobs + unstated_.size(); }
  double likelihood() const {
    return log_likelihood(level_residuals(dive_, options_), options_.gate_sigma);
  }
  bool may_turn(std::size_t knob, double by) const {
    const double after = turned_[knob] * by;
    if (knob < 2) return after * largest_change > 1 && after < largest_change;
    if (knob < motion_knobs) return after > 1 / longest_change && after < longest_change;
    return after > least_noise && after < largest_noise;
  }
  void turn(std::size_t knob, double by) {
    turned_[knob] *= by;
    if (knob == 0) options_.motion.velocity_mps *= by;
    if (knob == 1) options_.motion.turn_radps *= by;
    if (knob == 2) options_.motion.acceleration_s *= by;
    if (knob == 3) options_.motion.turn_change_s *= by;
    if (knob < motion_knobs) return;
    factors_[knob - motion_knobs] *= by;
    scale_noise(dive_, unstated_[knob - motion_knobs], by);
  }
  NoiseFit fit() const { return {options_.motion, factors_}; }

 private:
  Dive dive_;
  LevelOptions options_;
  const std::vector<UnstatedNoise>& unstated_;
  std::vector<double> factors_;
  std::vector<double> turned_ = std::vector<double>(motion_knobs + unstated_.size(), 1);
};

/// Turns a knob as long as that makes the readings more likely. True if it did once.
bool improve(Trial& trial, std::size_t knob, double by, double& best) {
  bool better = false;
  while (trial.may_turn(knob, by)) {
    trial.turn(knob, by);
    const double now = trial.likelihood();
    if (!(now > best)) {
      trial.turn(knob, 1 / by);
      break;
    }
    best = now;
    better = true;
  }
  return better;
}

}  // namespace

double log_likelihood(const Residuals& residuals, double gate_sigma) {
  const double edge = gate_sigma > 0 ? gate_sigma * gate_sigma : INFINITY;
  double sum = 0;
  for (const auto& axes : residuals)
    for (const Residual& r : axes) {
      if (!r.known) continue;
      const double square = r.normalised() * r.normalised();
      sum -= (square <= edge ? square : edge * (1 + std::log(square / edge))) / 2;
      sum -= std::log(r.sigma);
    }
  return sum;
}

void scale_noise(Dive& dive, const UnstatedNoise& sensor, double factor) {
  for (Reading& reading : dive.readings)
    if (reading.quantity == sensor.quantity && reading.device == sensor.device)
      reading.sigma *= factor;
}

NoiseFit fit_noise(const Dive& dive, const LevelOptions& options,
                   const std::vector<UnstatedNoise>& unstated) {
  Trial trial(dive, options, unstated);
  double best = trial.likelihood();
  double step = first_step;
  while (step > last_step) {
    for (std::size_t knob = 0; knob < trial.knobs(); ++knob)
      if (!improve(trial, knob, step, best)) improve(trial, knob, 1 / step, best);
    step = std::sqrt(step);
  }
  return trial.fit();
}

}  // namespace drydock::smoothing
