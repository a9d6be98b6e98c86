#pragma once

#include <Eigen/Core>

#include "drivers/measurement/measurement.hpp"

namespace drydock::pipeline {

/// The white noise of an IMU's samples, learned from them alone: eq. (I10) of
/// docs/estimators/integrity.md. A motion whose rate changes evenly over three samples adds
/// nothing to it. Allocates nothing.
class SampleNoise {
 public:
  /// It is a mean over so many samples, the latest counted most. A noise that begins has had this
  /// number of samples of the same variance more than the sum of what was learned since.
  static constexpr double samples = 100;

  /// Samples must be newer than the sample before.
  void add(const measurement::ImuSample& sample);
  /// Forgets the last samples, because of a gap. What was learned stays.
  void forget() { known_ = 0; }

  /// Variance of the noise of one sample, of the noisiest axis: rad2/s2, m2/s4.
  double rate_variance() const { return noise_.head<3>().maxCoeff(); }
  double force_variance() const { return noise_.tail<3>().maxCoeff(); }

 private:
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  measurement::Stamp at_{};
  double interval_s_ = 0;
  Vector6 last_ = Vector6::Zero(), change_ = Vector6::Zero();
  Vector6 noise_ = Vector6::Zero();
  int known_ = 0;  ///< of last_ and change_, in this order
};

/// The variance that noise has beyond what its sensor's data sheet says; 0 while the learned noise
/// is less than twice that.
inline double beyond_sheet(double learned, double sheet) {
  constexpr double twice = 4;  // of variances
  return learned > twice * sheet ? learned - sheet : 0;
}

}  // namespace drydock::pipeline
