#pragma once

#include <algorithm>
#include <cmath>

namespace drydock::consistency {

/// How well an offset is known whose residuals err by the same for some seconds, until that passes:
/// many of them at one time tell no more than one. docs/estimators/consistency.md
class PassingError {
 public:
  /// `floor`, `sigma`: 1 sigma of the residual in usual times, and of what is not known now.
  /// Gives the share of its deviation that the offset takes.
  double take(double floor, double sigma, double dt) {
    const double told = std::max(dt, 1e-3) / lasts_s / (floor * floor + sigma * sigma);
    known_ += told;
    return told / known_;
  }

  /// As well as `lasts_s` tell it of which all is known.
  bool is_known(double floor) const { return known_ * floor * floor >= 1; }
  /// Of the offset, above that.
  double variance(double floor) const { return std::max(0.0, 1 / known_ - floor * floor); }

 private:
  static constexpr double lasts_s = 10;
  double known_ = 0;  ///< 1 / variance
};

}  // namespace drydock::consistency
