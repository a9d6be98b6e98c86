#include "estimators/consistency/surge.hpp"

#include <algorithm>

namespace drydock::consistency {
namespace {

/// Two low passes of this time; they make the derivative of a speed with noise.
constexpr double surge_filter_s = 2;
/// 1 sigma around 0: a ship with a propeller of 5 m a turn and a hull of 100 m still fits.
constexpr double usual_thrust_m2 = 1, usual_way_m = 300, usual_turn_m2 = 100;
/// e is 0 or 1.
constexpr double middle_share = 0.5, share_sigma = 0.5;
constexpr double surge_noise_mps = 0.2;     // of one step; neighbours are not independent
constexpr double surge_memory = 0.9998;     // a step of 0.2 s: 1000 s
constexpr double known_thrust_share = 0.1;  // of a: then the law is known
constexpr double fewest_steps = 200;
/// m itself differs between manoeuvres by so much.
constexpr double way_share = 0.1, least_way_sigma_m = 0.5;
constexpr double slowest_mps = 0.2;

}  // namespace

Surge::Surge()
    : fit_({usual_thrust_m2, usual_way_m, usual_turn_m2, share_sigma}, surge_noise_mps,
           surge_memory),
      law_(fit_.solve()) {}

void Surge::follow(Filtered& of, const Filtered& by, double share) {
  of.thrust += share * (by.thrust - of.thrust);
  of.speed += share * (by.speed - of.speed);
  of.square += share * (by.square - of.square);
  of.turn += share * (by.turn - of.turn);
  of.drift += share * (by.drift - of.drift);
}

void Surge::take(const Input& input, double dt) {
  move(input, dt);
  if (!input.speed_mps) {
    begun_ = false;
    return;
  }
  const double speed = *input.speed_mps;
  const Filtered now{input.shaft_radps * std::abs(input.shaft_radps), speed, speed * speed,
                     input.turn_radps * input.turn_radps, 2 * speed * input.current_mps};
  if (!begun_) once_ = twice_ = now;
  begun_ = true;
  const double share = dt / (surge_filter_s + dt);
  follow(once_, now, share);
  follow(twice_, once_, share);
}

/// du/dt = (a n^2 - d r^2 - u^2) / m with u less e c, exact over a step in which u changes little.
void Surge::move(const Input& input, double dt) {
  if (!known_) return;
  const double thrust = input.shaft_radps * std::abs(input.shaft_radps);
  const double turn = input.turn_radps * input.turn_radps;
  const double steady = std::max(0.0, law_.value[0] * thrust - law_.value[2] * turn);
  const double sigma_m = std::hypot(law_.sigma(1), way_share * law_.value[1], least_way_sigma_m);
  const double drift = current_share() * input.current_mps;
  for (std::size_t i = 0; i < speeds_.size(); ++i) {
    constexpr std::array sigmas{0.0, -1.0, 1.0};
    const double way_m = std::max(law_.value[1] + sigmas[i] * sigma_m, 1e-3);
    const double through = std::max(speeds_[i] - drift, 0.0);
    const double share = 1 - std::exp(-2 * std::max(through, slowest_mps) * dt / way_m);
    speeds_[i] = std::sqrt(through * through + share * (steady - through * through)) + drift;
  }
}

double Surge::current_share() const { return middle_share + law_.value[3]; }

/// The derivative of a low pass is its input less its output, over its time.
Surge::Fit::Vector Surge::terms() const {
  return {twice_.thrust, -(once_.speed - twice_.speed) / surge_filter_s, -twice_.turn,
          twice_.drift};
}

void Surge::learn() {
  if (!begun_) return;
  const double twice_speed = 2 * std::max(std::abs(twice_.speed), slowest_mps);
  fit_.add((twice_.square - middle_share * twice_.drift) / twice_speed, terms() / twice_speed);
  law_ = fit_.solve();
  if (known_ || fit_.count() < fewest_steps || law_.sigma(0) > known_thrust_share * law_.value[0])
    return;
  known_ = true;
  speeds_.fill(once_.speed);
}

/// What is not known of m is the difference between a quicker and a slower hull.
std::optional<Surge::Answer> Surge::answer() const {
  if (!known_) return {};
  Fit::Vector steady = terms();
  steady[1] = 0;
  const double likely = speeds_[0];
  const double of_law = begun_ ? law_.sigma_of(steady / (2 * std::max(likely, slowest_mps))) : 0;
  const double of_way = std::max(std::abs(speeds_[1] - likely), std::abs(speeds_[2] - likely));
  return Answer{likely, std::hypot(of_law, of_way)};
}

}  // namespace drydock::consistency
