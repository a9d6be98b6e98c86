#pragma once

#include <array>
#include <optional>

#include "estimators/consistency/constant_fit.hpp"

namespace drydock::consistency {

/// The law of surge: a n^2 = u^2 - 2 e u c + m du/dt + d r^2, with n the turns of the shaft, u the
/// speed over ground, c the current along and r the rate of turn. A hull needs some lengths to
/// reach the speed of its shaft, and loses some in a turn; e is 1 for a propeller in the water.
/// a, m, d and e are learned. docs/estimators/consistency.md (14)
class Surge {
 public:
  Surge();

  struct Input {
    double shaft_radps = 0;
    std::optional<double> speed_mps{};  ///< over ground, of other sensors; empty: none tells it
    double current_mps = 0, turn_radps = 0;
  };
  /// One step of time.
  void take(const Input& input, double dt);
  /// The state of the last step teaches the law. Only while nothing accuses the shaft.
  void learn();

  struct Answer {
    double speed_mps = 0, sigma_mps = 0;  ///< over ground
  };
  /// What the turns until now make. Empty until the shaft has driven the vehicle for some time.
  std::optional<Answer> answer() const;

 private:
  using Fit = ConstantFit<4>;
  Fit::Vector terms() const;
  void move(const Input& input, double dt);
  double current_share() const;

  struct Filtered {
    double thrust = 0, speed = 0, square = 0, turn = 0, drift = 0;  ///< n^2, u, u^2, r^2, 2 u c
  };
  static void follow(Filtered& of, const Filtered& by, double share);

  Fit fit_;
  Filtered once_, twice_;
  /// That the shaft makes: with the likely m, and with one sigma less and more.
  std::array<double, 3> speeds_{};
  Fit::Answer law_;
  bool begun_ = false, known_ = false;
};

}  // namespace drydock::consistency
