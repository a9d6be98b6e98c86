#pragma once

#include <array>
#include <optional>

#include "estimators/consistency/constant_fit.hpp"

namespace drydock::consistency {

/// Nomoto's first-order law of steering over the way s: rudder = a k + b dk/ds + zero, k the
/// curvature of the way in 1/m. A hull turns later than its rudder, by about its own length. The
/// three are learned while the vehicle turns. docs/estimators/consistency.md (13)
class Helm {
 public:
  Helm();

  /// One step of time. `speed_mps` > 0; rudder in rad, any sense.
  void take(double rudder_rad, double curvature_1pm, double speed_mps, double dt);
  /// The state of the last step teaches the law. Only while nothing accuses the rudder.
  void learn();
  /// What the law says wrong now counts for its sigma. While no alarm accuses the rudder.
  void note_wrong();
  /// After a gap the filters begin anew; what was learned stays.
  void interrupt() { begun_ = false; }

  struct Answer {
    double rudder_rad = 0;  ///< as it was said when the filtered curvature was true
    double needed_rad = 0;  ///< for the curvature
    double sigma_rad = 0;   ///< of the law
  };
  /// Empty until the vehicle has turned enough.
  std::optional<Answer> answer();
  /// Sum of the squares of what the law said wrong before it learned each step, in sigmas.
  double misfit() const { return misfit_; }

 private:
  using Fit = ConstantFit<3>;
  Fit::Vector terms() const;
  double wrong() const;

  Fit fit_;
  std::array<double, 5> rudders_{};  ///< rad, the newest first
  double once_ = 0, twice_ = 0;      ///< curvature behind one and two low passes
  double speed_mps_ = 1, misfit_ = 0;
  double excited_rad_ = 0;                ///< the rudder that lately turned the hull
  double wrong_square_, excited_square_;  ///< sums
  bool begun_ = false, known_ = false;
};

}  // namespace drydock::consistency
