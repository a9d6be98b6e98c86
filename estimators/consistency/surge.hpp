#pragma once

#include "estimators/consistency/surge_law.hpp"

namespace drydock::consistency {

/// The speed that a shaft makes. A propeller drives through the water; an emulated vehicle may obey
/// the same law over ground. Both are followed, and the one that fits counts.
/// docs/estimators/consistency.md (14)
class Surge {
 public:
  struct Input {
    double shaft_radps = 0;
    std::optional<double> speed_mps{};  ///< ahead over ground, of other sensors; empty: none tells
    double starboard_mps = 0;           ///< over ground
    std::optional<double> turn_radps = 0;               ///< empty: the speed is that of the others
    double current_mps = 0, current_starboard_mps = 0;  ///< of the water, in body axes
    double current_sigma_mps = 0;                       ///< of its part ahead
  };
  /// One step of time.
  void take(const Input& input, double dt);
  /// The state of the last step teaches the law. Only while nothing accuses the shaft.
  void learn();

  struct Answer {
    double speed_mps = 0, sigma_mps = 0;  ///< ahead over ground
  };
  /// What the turns until now make. Empty until the shaft has driven the vehicle for some time.
  std::optional<Answer> answer() const;

 private:
  SurgeLaw over_ground_, through_water_;
  double current_mps_ = 0, current_sigma_mps_ = 0;
};

}  // namespace drydock::consistency
