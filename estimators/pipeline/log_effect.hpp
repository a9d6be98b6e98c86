#pragma once

#include <Eigen/Core>
#include <cmath>

#include "estimators/leveling/any_leveling_filter.hpp"

namespace drydock::pipeline {

/// What a log has changed of a leveling filter in the last seconds, the latest counted most. If the
/// log was wrong, the filter is wrong by about as much. Allocates nothing.
class LogEffect {
 public:
  static constexpr double span_s = 10;  ///< chosen: some times what a contradiction takes to show

  /// Roll and pitch (rad); biases of accelerometers (m/s2) and gyros (rad/s), if it has them.
  using Parts = Eigen::Matrix<double, 8, 1>;
  static Parts parts_of(const leveling::LevelingFilter& filter) {
    Parts parts = Parts::Zero();
    parts.head<2>() << filter.roll(), filter.pitch();
    return parts;
  }
  static Parts parts_of(const leveling::AugmentedLevelingFilter& filter) {
    Parts parts;
    parts << filter.roll(), filter.pitch(), filter.accelerometer_bias(), filter.gyro_bias();
    return parts;
  }

  void wait(double dt) { waited_s_ += dt; }
  /// A speed changed the filter from one state to the other.
  void add(const Parts& before, const Parts& after) {
    sum_ = std::exp(-waited_s_ / span_s) * sum_ + after - before;
    waited_s_ = 0;
  }
  /// Widens the filter's covariance by what was changed, and forgets it.
  void doubt(auto& filter) {
    filter.loosen(0, sum_.head<2>().norm());
    filter.loosen_biases(sum_.tail<3>().norm(), sum_.segment<3>(2).norm());
    forget();
  }
  void forget() { *this = {}; }

 private:
  Parts sum_ = Parts::Zero();
  double waited_s_ = 0;  ///< since the last speed
};

}  // namespace drydock::pipeline
