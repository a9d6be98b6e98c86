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
constexpr double part_sigma = 0.1;   // of a k and of b dk/ds: they differ by manoeuvres
constexpr double known_share = 0.1;  // of a: then the law is known

}  // namespace

Helm::Helm() : fit_({usual_a_m, usual_b_m2, usual_zero}, steering_noise, steered_memory) {}

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
}

/// The derivative of a low pass is its input less its output, over its time.
Helm::Fit::Vector Helm::terms() const {
  return {twice_, (once_ - twice_) / filter_s / speed_mps_, 1};
}

void Helm::learn() {
  const double wrong = (rudders_.back() - fit_.solve().value.dot(terms())) / steering_noise;
  misfit_ = steered_memory * misfit_ + wrong * wrong;
  fit_.add(rudders_.back(), terms());
}

std::optional<Helm::Answer> Helm::answer() {
  const Fit::Answer law = fit_.solve();
  known_ = known_ || law.sigma(0) < known_share * std::abs(law.value[0]);
  if (!known_) return {};
  const Eigen::Vector2d parts = law.value.cwiseProduct(terms()).head<2>();
  return Answer{rudders_.back(), law.value.dot(terms()),
                std::hypot(law.sigma_of(terms()), part_sigma * parts.norm())};
}

}  // namespace drydock::consistency
