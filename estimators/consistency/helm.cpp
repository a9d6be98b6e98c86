#include "estimators/consistency/helm.hpp"

#include "drivers/measurement/units.hpp"

namespace drydock::consistency {
namespace {

/// Two low passes of this time; they make the derivative of a curvature with noise.
constexpr double filter_s = 1;
/// 1 sigma around 0: a ship of 100 m still fits.
constexpr double usual_a_m = 100, usual_b_m2 = 1000, usual_zero = 2 * units::degree;
constexpr double steering_noise = 1 * units::degree;  // of one step; neighbours are not independent
constexpr double steered_memory = 0.9993;             // a step of 0.2 s: 300 s
constexpr double known_share = 0.1;                   // of a: then the law is known

}  // namespace

Helm::Helm() : fit_({usual_a_m, usual_b_m2, usual_zero}, steering_noise, steered_memory) {}

void Helm::take(double rudder_rad, double curvature_1pm, double speed_mps, double dt) {
  const Eigen::Vector2d now{rudder_rad, curvature_1pm};
  if (!begun_) once_ = twice_ = now;
  begun_ = true;
  const double share = dt / (filter_s + dt);
  once_ += share * (now - once_);
  twice_ += share * (once_ - twice_);
  speed_mps_ = speed_mps;
}

/// The derivative of a low pass is its input less its output, over its time.
Helm::Fit::Vector Helm::terms() const {
  return {twice_.y(), (once_.y() - twice_.y()) / filter_s / speed_mps_, 1};
}

void Helm::learn() { fit_.add(twice_.x(), terms()); }

std::optional<Helm::Answer> Helm::answer() {
  const Fit::Answer law = fit_.solve();
  known_ = known_ || law.sigma(0) < known_share * std::abs(law.value[0]);
  if (!known_) return {};
  return Answer{twice_.x(), law.value.dot(terms()), law.sigma_of(terms())};
}

}  // namespace drydock::consistency
