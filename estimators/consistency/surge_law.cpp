#include "estimators/consistency/surge_law.hpp"

#include <algorithm>

namespace drydock::consistency {
namespace {

/// Two low passes of this time; they make the derivative of a speed with noise.
constexpr double surge_filter_s = 4;
/// 1 sigma around 0: a ship with a propeller of 5 m a turn and a hull of 100 m still fits.
constexpr double usual_thrust_m2 = 1, usual_way_m = 300, usual_drift_m = 20, usual_turn_m2 = 100;
constexpr double surge_noise_mps = 0.1;     // of one step; neighbours are not independent
constexpr double surge_memory = 0.9998;     // a step of 0.2 s: 1000 s
constexpr double known_thrust_share = 0.1;  // of a: then the law is known
constexpr double fewest_steps = 200;
/// m itself differs between manoeuvres by so much.
constexpr double way_share = 0.1, least_way_sigma_m = 0.5;
/// 1 sigma of dw/dt that noise makes, of 1 m/s of noise of the speed: five times that of white
/// noise, since sensors err for longer than a step.
constexpr double change_of_noise = 0.12;
constexpr double speed_noise_samples = 300;
/// So does d r^2: a rudder that is put over slows before the hull turns, and drift comes last.
constexpr double turn_share = 0.1;
constexpr double slowest_mps = 0.2, least_way_m = 1e-3;

double surge_square(double x) { return x * x; }

}  // namespace

SurgeLaw::SurgeLaw()
    : fit_({usual_thrust_m2, usual_way_m, usual_drift_m, usual_turn_m2}, surge_noise_mps,
           surge_memory),
      law_(fit_.solve()) {}

void SurgeLaw::follow(Filtered& of, const Filtered& by, double share) {
  of.thrust += share * (by.thrust - of.thrust);
  of.speed += share * (by.speed - of.speed);
  of.square += share * (by.square - of.square);
  of.drift += share * (by.drift - of.drift);
  of.turn += share * (by.turn - of.turn);
}

void SurgeLaw::take(const Input& input, double dt) {
  if (!input.turn_radps) return begin_at(input.ahead_mps);
  const double speed = input.ahead_mps.value_or(0), turn = *input.turn_radps;
  const Filtered now{input.shaft_radps * std::abs(input.shaft_radps), speed, surge_square(speed),
                     turn * input.starboard_mps, surge_square(turn)};
  move(now, dt);
  if (!input.ahead_mps) {
    begun_ = false;
    return;
  }
  if (!begun_) once_ = twice_ = now;
  if (!begun_) lately_ = 0;
  begun_ = true;
  note_noise(speed);
  const double share = dt / (surge_filter_s + dt);
  follow(once_, now, share);
  follow(twice_, once_, share);
}

/// The second difference of a speed knows no steady change: of noise it is six times its square.
void SurgeLaw::note_noise(double speed_mps) {
  std::shift_right(recent_mps_.begin(), recent_mps_.end(), 1);
  recent_mps_[0] = speed_mps;
  if (++lately_ < recent_mps_.size()) return;
  const double bend = recent_mps_[0] - 2 * recent_mps_[recent_mps_.size() / 2] + recent_mps_.back();
  samples_ = std::min(samples_ + 1, speed_noise_samples);
  speed_noise_square_ += (bend * bend / 6 - speed_noise_square_) / samples_;
}

/// What a turn takes is not known now.
void SurgeLaw::begin_at(std::optional<double> ahead_mps) {
  begun_ = false;
  if (!ahead_mps) return;
  speeds_.fill(std::max(0.0, *ahead_mps));
  moved_.setZero();
}

/// The noise of dw/dt seems to tell m, and that it is small. Without a change of speed there is
/// nothing else.
double SurgeLaw::way_sigma_m(const Fit::Answer& law) const {
  const double told = 1 / surge_square(law.sigma(1));
  const double sure = std::max(told - noise_told_, 1 / surge_square(usual_way_m));
  const double lost = std::min(usual_way_m, std::abs(law.value[1]) * (told - sure) / sure);
  const double share = std::max(way_share * std::abs(law.value[1]), least_way_sigma_m);
  return std::sqrt(1 / sure + lost * lost + share * share);
}

/// dw/dt = (a n^2 + g r v - d r^2 - w^2) / m, exact over a step in which w changes little. The
/// derivatives of w with respect to a, g and d obey the same equation.
void SurgeLaw::move(const Filtered& drive, double dt) {
  if (!known_) return;
  const Fit::Vector drives{drive.thrust, 0, drive.drift, -drive.turn};
  const double steady = std::max(0.0, law_.value.dot(drives));
  const double sigma_m = law_.sigma(1);
  const auto share_at = [&](double speed, double way_m) {
    return 1 - std::exp(-2 * std::max(speed, slowest_mps) * dt / std::max(way_m, least_way_m));
  };
  const double likely = std::max(speeds_[0], slowest_mps);
  moved_ += share_at(likely, law_.value[1]) * (drives / (2 * likely) - moved_);
  for (std::size_t i = 0; i < speeds_.size(); ++i) {
    constexpr std::array sigmas{0.0, -1.0, 1.0};
    double& speed = speeds_[i];
    const double share = share_at(speed, law_.value[1] + sigmas[i] * sigma_m);
    speed = std::sqrt(surge_square(speed) + share * (steady - surge_square(speed)));
  }
}

/// The derivative of a low pass is its input less its output, over its time.
SurgeLaw::Fit::Vector SurgeLaw::terms() const {
  return {twice_.thrust, -(once_.speed - twice_.speed) / surge_filter_s, twice_.drift,
          -twice_.turn};
}

void SurgeLaw::learn() {
  if (!begun_) return;
  const double twice_speed = 2 * std::max(std::abs(twice_.speed), slowest_mps);
  const double y = twice_.square / twice_speed;
  const Fit::Vector x = terms() / twice_speed;
  if (known_)
    misfit_ = surge_memory * misfit_ + surge_square((y - law_.value.dot(x)) / surge_noise_mps);
  fit_.add(y, x);
  noise_told_ = surge_memory * noise_told_ +
                surge_square(change_of_noise / twice_speed / surge_noise_mps) * speed_noise_square_;
  auto law = fit_.solve();
  law.widen(1, way_sigma_m(law));
  believe(law);
}

/// The speeds become what the new law would have made of the same turns.
void SurgeLaw::believe(const Fit::Answer& law) {
  if (known_)
    for (double& speed : speeds_) speed = std::max(0.0, speed + moved_.dot(law.value - law_.value));
  law_ = law;
  if (known_ || fit_.count() < fewest_steps || law_.sigma(0) > known_thrust_share * law_.value[0])
    return;
  known_ = true;
  // Not the low-passed one: of a hull that brakes by 0.1 m/s2 that lags by 0.4 m/s.
  speeds_.fill(std::max(0.0, recent_mps_[0]));
}

/// What is not known of m is the difference between a quicker and a slower hull.
std::optional<Likely> SurgeLaw::answer() const {
  if (!known_) return {};
  const double likely = speeds_[0];
  const double of_way = std::max(std::abs(speeds_[1] - likely), std::abs(speeds_[2] - likely));
  const double of_turn = turn_share * moved_[3] * law_.value[3];
  return Likely{likely, std::hypot(law_.sigma_of(moved_), of_way, of_turn)};
}

}  // namespace drydock::consistency
