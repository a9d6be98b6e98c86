#pragma once

#include <optional>

#include "estimators/consistency/constant_fit.hpp"

namespace drydock::consistency {

/// The law of surge: a n^2 = u^2 + m du/dt + d r^2, with n the turns of the shaft, u the speed
/// through the water and r the rate of turn. A hull needs some lengths to reach the speed of its
/// shaft, and loses some in a turn. a, m and d are learned. docs/estimators/consistency.md (14)
class Surge {
 public:
  Surge();

  /// One step of time. `speed_mps`: through the water, of other sensors; empty: none tells it.
  void take(double shaft_radps, std::optional<double> speed_mps, double turn_radps, double dt);
  /// The state of the last step teaches the law. Only while nothing accuses the shaft.
  void learn();

  struct Answer {
    double speed_mps = 0, sigma_mps = 0;
  };
  /// What the turns until now make. Empty until the shaft has driven the vehicle for some time.
  std::optional<Answer> answer() const;

 private:
  using Fit = ConstantFit<3>;
  Fit::Vector terms() const;
  void move(double shaft_radps, double turn_radps, double dt);

  struct Filtered {
    double thrust = 0, speed = 0, square = 0, turn = 0;  ///< n^2, u, u^2, r^2
  };
  static void follow(Filtered& of, const Filtered& by, double share);

  Fit fit_;
  Filtered once_, twice_;
  double square_ = 0;  ///< of the speed that the shaft makes
  double lacking_mps_ = 0;
  Fit::Answer law_;
  bool begun_ = false, known_ = false;
};

}  // namespace drydock::consistency
