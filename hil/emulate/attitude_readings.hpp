#pragma once

#include <cmath>
#include <numbers>

#include "hil/emulate/sampling_device.hpp"
#include "hil/sensor/ideal.hpp"

namespace drydock::emulate {

/// The truth as a compass reads it: primary errors on roll, pitch and heading, secondary errors on
/// the rate of turn.
class AttitudeReadings {
 public:
  explicit AttitudeReadings(const DeviceSetup& setup)
      : angle_errors_(setup.primary_errors()), turn_errors_(setup.secondary_errors()) {}

  measurement::AttitudeSample at(const motion::Truth& truth, const sensor::Mounting& mounting) {
    auto sample = sensor::ideal_attitude(truth, mounting);
    const Eigen::Vector3d angles =
        angle_errors_.apply({*sample.roll_rad, *sample.pitch_rad, *sample.heading_rad}, truth.at);
    constexpr double circle = 2 * std::numbers::pi;
    sample.roll_rad = std::remainder(angles.x(), circle);
    sample.pitch_rad = angles.y();
    sample.heading_rad = angles.z() - circle * std::floor(angles.z() / circle);
    sample.rate_of_turn_radps = turn_errors_.apply(*sample.rate_of_turn_radps, truth.at);
    return sample;
  }

 private:
  sensor::ErrorModel angle_errors_, turn_errors_;
};

}  // namespace drydock::emulate
