#include "estimators/consistency/shaft_law.hpp"

#include <algorithm>

namespace drydock::consistency {
namespace {

/// The second law learns for at least so long: it shall see changes of the speed.
constexpr double shortest_trial_s = 120;
/// Of the time of a trial.
constexpr double lately_share = 0.25;
/// A fault that ends in the trial makes the first law right again. A law that is wrong at one speed
/// may be right at another for a leg or two.
constexpr double acquitted_after_s = 180;
/// Of the squares of what the first law said wrong.
constexpr double far_better_share = 0.25;

double shaft_square(double x) { return x * x; }

}  // namespace

void ShaftLaw::take(const Surge::Input& input, double dt, bool quiet, bool accused) {
  law_.take(input, dt);
  if (quiet) {
    law_.learn();
    learned_s_ += dt;
  }
  begins_anew_ = false;
  if (accused && !rival_) rival_ = Rival{.until_s = std::max(learned_s_, shortest_trial_s)};
  if (!rival_) return;
  rival_->take(input, dt, law_.answer(), accused);
  if (!rival_->is_over(accused)) return;
  if (accused && rival_->fits_far_better()) {
    begins_anew_ = true;
    law_ = rival_->law;
    learned_s_ = rival_->age_s;
  }
  rival_.reset();
}

void ShaftLaw::Rival::take(const Surge::Input& input, double dt,
                           const std::optional<Surge::Answer>& first, bool accused) {
  law.take(input, dt);
  age_s += dt;
  quiet_s = accused ? 0 : quiet_s + dt;
  const auto own = law.answer();
  if (first && own && input.speed_mps) {
    const double share = dt / (lately_share * until_s + dt);
    of_first += share * (shaft_square(first->speed_mps - *input.speed_mps) - of_first);
    of_own += share * (shaft_square(own->speed_mps - *input.speed_mps) - of_own);
  }
  law.learn();
}

bool ShaftLaw::Rival::is_over(bool accused) const {
  return quiet_s >= acquitted_after_s || (accused && age_s >= until_s);
}

bool ShaftLaw::Rival::fits_far_better() const { return of_own < far_better_share * of_first; }

}  // namespace drydock::consistency
