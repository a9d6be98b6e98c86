#pragma once

#include <optional>

#include "drivers/measurement/measurement.hpp"
#include "hil/sensor/increments.hpp"

namespace drydock::sensor {

/// The samples of an ideal inertial unit: the values at the sample time, or, for a unit that
/// integrates, their means over the sample interval that ends there.
class ImuSampler {
 public:
  ImuSampler(const motion::Trajectory& trajectory, const Mounting& mounting, double rate_hz,
             bool means);

  /// Times must not decrease.
  measurement::ImuSample at(motion::Stamp time);

 private:
  const motion::Trajectory& trajectory_;
  Mounting mounting_;
  std::chrono::nanoseconds period_;
  bool means_;
  std::optional<IncrementIntegrator> integrator_;
  motion::Stamp integrated_to_{};
};

}  // namespace drydock::sensor
