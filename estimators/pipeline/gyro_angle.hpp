#pragma once

#include <array>
#include <cstddef>

#include "drivers/measurement/stamp.hpp"

namespace drydock::pipeline {

/// The integral of a gyro's rate, rad. It keeps the last samples, so that a late measurement can
/// use the angle at its own time.
class GyroAngle {
 public:
  void clear() { count_ = 0; }
  bool empty() const { return count_ == 0; }

  /// Adds the next sample, the rate at an instant. Between two samples the rate is their mean.
  void add(measurement::Stamp at, double rate_radps);

  double now() const { return newest().angle; }
  double rate() const { return newest().rate; }
  measurement::Stamp oldest() const;
  /// The angle at `time`, interpolated; after the newest sample extrapolated with its rate. `time`
  /// must not be before oldest().
  double at(measurement::Stamp time) const;

 private:
  struct Sample {
    measurement::Stamp at;
    double rate = 0, angle = 0;
  };
  static constexpr std::size_t capacity = 128;

  const Sample& sample(std::size_t i) const { return samples_[i % capacity]; }
  const Sample& newest() const { return sample(count_ - 1); }

  std::array<Sample, capacity> samples_{};
  std::size_t count_ = 0;  ///< sample i is stored at i % capacity
};

}  // namespace drydock::pipeline
