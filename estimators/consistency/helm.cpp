#include "estimators/consistency/helm.hpp"

#include <algorithm>

#include "drivers/measurement/units.hpp"

namespace drydock::consistency {
namespace {

/// Two low passes of this time make the derivative of a curvature with noise. They are 0.8 s late,
/// which is four steps of the checks.
constexpr double filter_s = 0.4;
/// 1 sigma around 0: a ship of 100 m still fits.
constexpr double usual_a_m = 100, usual_b_m2 = 1000, usual_zero = 2 * units::degree;
constexpr double steering_noise = 1 * units::degree;  // of one step; neighbours are not independent
constexpr double steered_memory = 0.9993;             // a step of 0.2 s: 300 s
/// What a k and b dk/ds leave over is a share of both: they differ by manoeuvres, and a hull that
/// drifts in its turn remembers it for some lengths.
constexpr double first_share = 0.3, least_share = 0.15, remembered_way_m = 25;
constexpr double first_turn = 100 * (10 * units::degree) * (10 * units::degree);  // 20 s, 10 deg
constexpr double known_share = 0.03;  // of a: then the law is known

}  // namespace

Helm::Helm()
    : fit_({usual_a_m, usual_b_m2, usual_zero}, steering_noise, steered_memory),
      wrong_square_(first_share * first_share * first_turn),
      excited_square_(first_turn) {}

void Helm::take(double rudder_rad, double curvature_1pm, double speed_mps, double dt) {
  if (!begun_) {
    rudders_.fill(rudder_rad);
    once_ = twice_ = curvature_1pm;
  }
  begun_ = true;
  std::shift_right(rudders_.begin(), rudders_.end(), 1);
  rudders_[0] = rudder_rad;
  const double share = dt / (filter_s + dt);
  once_ += share * (curvature_1pm - once_);
  twice_ += share * (once_ - twice_);
  speed_mps_ = speed_mps;
  const auto law = fit_.solve().value;
  const double parts = law.cwiseProduct(terms()).head<2>().norm();
  excited_rad_ = std::max(parts, excited_rad_ * std::exp(-speed_mps * dt / remembered_way_m));
}

double Helm::wrong() const { return rudders_.back() - fit_.solve().value.dot(terms()); }

void Helm::note_wrong() {
  const double off = wrong();
  wrong_square_ = steered_memory * wrong_square_ + off * off;
  excited_square_ = steered_memory * excited_square_ + excited_rad_ * excited_rad_;
}

/// The derivative of a low pass is its input less its output, over its time.
Helm::Fit::Vector Helm::terms() const {
  return {twice_, (once_ - twice_) / filter_s / speed_mps_, 1};
}

void Helm::learn() {
  const double sigmas = wrong() / steering_noise;
  misfit_ = steered_memory * misfit_ + sigmas * sigmas;
  fit_.add(rudders_.back(), terms());
}

std::optional<Helm::Answer> Helm::answer() {
  const Fit::Answer law = fit_.solve();
  known_ = known_ || law.sigma(0) < known_share * std::abs(law.value[0]);
  if (!known_) return {};
  const double share = std::max(least_share, std::sqrt(wrong_square_ / excited_square_));
  return Answer{rudders_.back(), law.value.dot(terms()),
                std::hypot(law.sigma_of(terms()), share * excited_rad_)};
}

}  // namespace drydock::consistency
