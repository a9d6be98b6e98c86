#pragma once

#include <cstdint>
#include <limits>

#include "estimators/leveling/leveling_options.hpp"

namespace drydock::leveling {

/// Innovation gate of the log's speed. A value further off than `speed_gate` of its sigmas is left
/// out; after so many in a row that they are no outliers it is the estimate that is wrong, and the
/// next one counts, against a velocity that is as uncertain as it differs. Open where the first
/// attitude is given: a filter that begins upside down must hear so from the log.
class SpeedGate {
 public:
  static constexpr int believed_after = 5;

  explicit SpeedGate(const LevelingOptions& options)
      : gate_(options.accelerometer_start ? options.speed_gate
                                          : std::numeric_limits<double>::infinity()) {}

  void start() { in_a_row_ = 0; }

  /// Whether the speed is to be used. `velocity_variance` is that of V_x, and grows when the log is
  /// believed against it; `sigma_squared` of the innovation.
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
