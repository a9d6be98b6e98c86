#pragma once

#include <array>
#include <optional>

#include "estimators/consistency/constant_fit.hpp"
#include "estimators/consistency/two_laws.hpp"

namespace drydock::consistency {

/// The law of surge: a n^2 = w^2 + m dw/dt - g r v + d r^2, with n the turns of the shaft, w and v
/// the speeds ahead and to starboard, r the rate of turn. a, m, g and d are learned.
/// docs/estimators/consistency.md (14)
class SurgeLaw {
 public:
  SurgeLaw();

  struct Input {
    double shaft_radps = 0;
    std::optional<double> ahead_mps{};  ///< of other sensors; empty: none tells it
    double starboard_mps = 0;
    std::optional<double> turn_radps{};  ///< empty: the hull is where the others say
  };
  /// One step of time.
  void take(const Input& input, double dt);
  /// The state of the last step teaches the law. Only while nothing accuses the shaft.
  void learn();

  /// Ahead, m/s: what the turns until now make. Empty until the shaft has driven the vehicle for
  /// some time.
  std::optional<Likely> answer() const;
  /// Sum of the squares of what the law said wrong before it learned each step, in sigmas.
  double misfit() const { return misfit_; }

 private:
  using Fit = ConstantFit<4>;
  struct Filtered {
    double thrust = 0, speed = 0, square = 0, drift = 0, turn = 0;  ///< n^2, w, w^2, r v, r^2
  };
  Fit::Vector terms() const;
  void move(const Filtered& drive, double dt);
  void begin_at(std::optional<double> ahead_mps);
  void believe(const Fit::Answer& law);
  double way_sigma_m(const Fit::Answer& law) const;

  void note_noise(double speed_mps);
  static void follow(Filtered& of, const Filtered& by, double share);

  Fit fit_;
  Filtered once_, twice_;
  /// That the shaft makes: with the likely m, and with one sigma less and more.
  std::array<double, 3> speeds_{};
  Fit::Vector moved_ = Fit::Vector::Zero();  ///< d(speed)/d(a, m, g, d)
  Fit::Answer law_;
  double misfit_ = 0, noise_told_ = 0;  ///< noise_told_: information on m, 1/m2
  std::array<double, 7> recent_mps_{};  ///< the newest first, over the period of a slow log
  std::size_t lately_ = 0;              ///< how many of them are without a gap
  double speed_noise_square_ = 0, samples_ = 0;
  bool begun_ = false, known_ = false;
};

}  // namespace drydock::consistency
