#pragma once

#include <cstdint>

namespace drydock::leveling {

/// Innovation gate of the log's speed. A value further off than `gate` of its sigmas is left out;
/// after so many in a row that they are no outliers it is the estimate that is wrong, and the next
/// one counts, against a velocity that is as uncertain as it differs.
class SpeedGate {
 public:
  static constexpr int believed_after = 5;

  void start() { in_a_row_ = 0; }

  /// Whether the speed is to be used. `velocity_variance` is that of V_x, and grows when the log is
  /// believed against it; `sigma_squared` of the innovation.
  bool passes(double residual, double sigma_squared, double gate, double& velocity_variance) {
    if (residual * residual <= gate * gate * sigma_squared) {
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
  int in_a_row_ = 0;
  std::uint64_t rejected_ = 0;
};

}  // namespace drydock::leveling
