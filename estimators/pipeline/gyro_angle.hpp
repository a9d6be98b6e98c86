#pragma once

#include <array>
#include <cstddef>

#include "drivers/measurement/stamp.hpp"

namespace drydock::pipeline {

/// What a gyro has counted, rad, with its last hundred samples, so that a measurement that comes
/// late can be taken for its own time.
class GyroAngle {
 public:
  void clear() { count_ = 0; }
  bool empty() const { return count_ == 0; }

  /// The next sample: the rate at its instant. The mean of two stands for the time between them.
  void add(measurement::Stamp at, double rate_radps);

  double now() const { return newest().angle; }
  double rate() const { return newest().rate; }
  measurement::Stamp oldest() const;
  /// Interpolated; after the newest sample, carried on with its rate. Not before oldest().
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
  std::size_t count_ = 0;  ///< sample i stands at i % capacity
};

}  // namespace drydock::pipeline
