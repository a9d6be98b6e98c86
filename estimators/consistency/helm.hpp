#pragma once

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
  /// After a gap the filters begin anew; what was learned stays.
  void interrupt() { begun_ = false; }

  struct Answer {
    double rudder_rad = 0;  ///< as it is said, filtered as the curvature is
    double needed_rad = 0;  ///< for the curvature
    double sigma_rad = 0;   ///< of what was learned
  };
  /// Empty until the vehicle has turned enough.
  std::optional<Answer> answer();

 private:
  using Fit = ConstantFit<3>;
  Fit::Vector terms() const;

  Fit fit_;
  Eigen::Vector2d once_ = Eigen::Vector2d::Zero(), twice_ = Eigen::Vector2d::Zero();
  double speed_mps_ = 1;
  bool begun_ = false, known_ = false;
};

}  // namespace drydock::consistency
