#include "estimators/consistency/surge.hpp"

namespace drydock::consistency {

void Surge::take(const Input& input, double dt) {
  current_mps_ = input.current_mps;
  current_sigma_mps_ = input.current_sigma_mps;
  SurgeLaw::Input ground{.shaft_radps = input.shaft_radps,
                         .ahead_mps = input.speed_mps,
                         .starboard_mps = input.starboard_mps,
                         .turn_radps = input.turn_radps};
  over_ground_.take(ground, dt);
  SurgeLaw::Input& water = ground;
  if (water.ahead_mps) *water.ahead_mps -= input.current_mps;
  water.starboard_mps -= input.current_starboard_mps;
  through_water_.take(water, dt);
}

void Surge::learn() {
  over_ground_.learn();
  through_water_.learn();
}

std::optional<Surge::Answer> Surge::answer() const {
  const auto ground = over_ground_.answer();
  auto water = through_water_.answer();
  if (!ground || !water) return {};
  water->value += current_mps_;
  water->sigma = std::hypot(water->sigma, current_sigma_mps_);
  const Likely both =
      mixed(*ground, *water, share_of_second(over_ground_.misfit(), through_water_.misfit()));
  return Answer{both.value, both.sigma};
}

}  // namespace drydock::consistency
