#include "estimators/consistency/surge.hpp"

#include <algorithm>

namespace drydock::consistency {
namespace {

/// Two low passes of this time; they make the derivative of a speed with noise.
constexpr double surge_filter_s = 2;
/// 1 sigma around 0: a ship with a propeller of 5 m a turn and a hull of 100 m still fits.
constexpr double usual_thrust_m2 = 1, usual_way_m = 300, usual_turn_m2 = 300;
constexpr double square_noise = 0.2;        // m2/s2, of one step; neighbours are not independent
constexpr double surge_memory = 0.9998;     // a step of 0.2 s: 1000 s
constexpr double known_thrust_share = 0.1;  // of a: then the law is known
constexpr double fewest_steps = 50;
/// Of the speed that the hull has still to win or lose.
constexpr double lacking_share = 0.3;
constexpr double slowest_square = 0.04;  // m2/s2

}  // namespace

Surge::Surge()
    : fit_({usual_thrust_m2, usual_way_m, usual_turn_m2}, square_noise, surge_memory),
      law_(fit_.solve()) {}

void Surge::follow(Filtered& of, const Filtered& by, double share) {
  of.thrust += share * (by.thrust - of.thrust);
  of.speed += share * (by.speed - of.speed);
  of.square += share * (by.square - of.square);
  of.turn += share * (by.turn - of.turn);
}

void Surge::take(double shaft_radps, std::optional<double> speed_mps, double turn_radps,
                 double dt) {
  move(shaft_radps, turn_radps, dt);
  if (!speed_mps) {
    begun_ = false;
    return;
  }
  const Filtered now{shaft_radps * std::abs(shaft_radps), *speed_mps, *speed_mps * *speed_mps,
                     turn_radps * turn_radps};
  if (!begun_) once_ = twice_ = now;
  begun_ = true;
  const double share = dt / (surge_filter_s + dt);
  follow(once_, now, share);
  follow(twice_, once_, share);
}

/// du/dt = (a n^2 - d r^2 - u^2) / m, exact over a step in which u changes little.
void Surge::move(double shaft_radps, double turn_radps, double dt) {
  if (!known_) return;
  const double thrust = shaft_radps * std::abs(shaft_radps), turn = turn_radps * turn_radps;
  const double steady = std::max(0.0, law_.value[0] * thrust - law_.value[2] * turn);
  const double way_m = std::max(law_.value[1], 1e-3);
  const double speed = std::sqrt(std::max(square_, slowest_square));
  square_ += (1 - std::exp(-2 * speed * dt / way_m)) * (steady - square_);
  lacking_mps_ = std::sqrt(steady) - std::sqrt(square_);
}

/// The derivative of a low pass is its input less its output, over its time.
Surge::Fit::Vector Surge::terms() const {
  return {twice_.thrust, -(once_.speed - twice_.speed) / surge_filter_s, -twice_.turn};
}

void Surge::learn() {
  if (!begun_) return;
  fit_.add(twice_.square, terms());
  law_ = fit_.solve();
  if (known_ || fit_.count() < fewest_steps ||
      law_.sigma(0) > known_thrust_share * law_.value[0])
    return;
  known_ = true;
  square_ = once_.square;
}

std::optional<Surge::Answer> Surge::answer() const {
  if (!known_) return {};
  const double speed = std::sqrt(square_);
  const double square_sigma = begun_ ? law_.sigma_of(terms()) : 0;
  return Answer{speed, std::hypot(square_sigma / (2 * std::max(speed, std::sqrt(slowest_square))),
                                  lacking_share * lacking_mps_)};
}

}  // namespace drydock::consistency
