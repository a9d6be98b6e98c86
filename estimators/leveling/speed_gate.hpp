#pragma once

#include <cstdint>
#include <limits>

#include "estimators/leveling/leveling_options.hpp"

namespace drydock::leveling {

/// Innovation gate of the speed of the log. It rejects a value with an innovation above
/// `speed_gate` sigmas. After `believed_after` rejections in a row it assumes that the estimate is
/// wrong: it uses the next value and adds the squared innovation to the variance of the velocity.
/// The gate is open if the options give the first attitude, because such a filter may start upside
/// down and only the log can correct it.
class SpeedGate {
 public:
  static constexpr int believed_after = 5;

  explicit SpeedGate(const LevelingOptions& options)
      : gate_(options.accelerometer_start ? options.speed_gate
                                          : std::numeric_limits<double>::infinity()) {}

  void start() { in_a_row_ = 0; }

  /// True if the filter must use the speed. `sigma_squared` is the variance of the innovation.
  /// `velocity_variance` is the variance of V_x; it grows if the gate uses a value far outside.
  bool passes(double residual, double sigma_squared, double& velocity_variance) {
    if (residual * residual <= gate_ * gate_ * sigma_squared) {
      in_a_row_ = 0;
      return true;
    }
    if (in_a_row_ < believed_after) {
      ++in_a_row_;
      ++rejected_;
      return false;
    }
    in_a_row_ = 0;
    velocity_variance += residual * residual;
    return true;
  }

  std::uint64_t rejected() const { return rejected_; }

 private:
  double gate_;
  int in_a_row_ = 0;
  std::uint64_t rejected_ = 0;
};

}  // namespace drydock::leveling
