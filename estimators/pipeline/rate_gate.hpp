#pragma once

#include <chrono>
#include <optional>

#include "drivers/measurement/stamp.hpp"

namespace drydock::pipeline {

/// Recognises samples of one gyro that leap away and back, or stand still: what (I2) to (I4) of
/// docs/estimators/integrity.md do for a whole IMU, with limits of an airframe. A leap that lasts
/// is believed: motors fire. It learns the gyro's noise from the differences of successive samples.
/// Allocates nothing, throws nothing.
class RateGate {
 public:
  /// `spin_up_radps2`: the angular acceleration that it believes at once.
  explicit RateGate(double spin_up_radps2) : spin_up_radps2_(spin_up_radps2) {}

  /// True: use it. Samples must be newer than the sample before.
  bool believes(measurement::Stamp at, double rate_radps);
  /// One sigma of the noise of a sample, rad/s; without limit until it is learned.
  double noise() const;
  /// Forgets the last sample, because of a gap. The noise stays known.
  void forget();

 private:
  struct Point {
    measurement::Stamp at;
    double rate;
  };
  bool reachable(const Point& from, const Point& to) const;
  bool stands_still(double rate);
  bool take(const Point& now);

  double spin_up_radps2_;
  std::optional<Point> good_, leapt_;  ///< the last good sample; the newest that leapt from it
  int agreeing_ = 0;                   ///< samples in a row that leapt to about one place
  std::optional<double> newest_;       ///< rate
  int still_ = 0;                      ///< samples in a row that are equal to the one before
  double usual_ = 0;                   ///< mean absolute difference of successive samples
  int learned_ = 0;                    ///< differences that were not zero, up to enough
};

}  // namespace drydock::pipeline
