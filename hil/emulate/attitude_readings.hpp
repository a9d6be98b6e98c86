#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "hil/emulate/sampling_device.hpp"
#include "hil/sensor/ideal.hpp"

namespace drydock::emulate {

/// The truth as a compass reads it: primary errors on roll, pitch and heading, secondary errors on
/// the rate of turn, and the error that the rig knows of it. The rig says which variation it knows,
/// and to which north it points. It tells no deviation.
class AttitudeReadings {
 public:
  explicit AttitudeReadings(const DeviceSetup& setup)
      : angle_errors_(setup.primary_errors()),
        turn_errors_(setup.secondary_errors()),
        compass_(setup.config.emulate.compass),
        error_rad_(setup.config.compass_error_rad) {}

  measurement::AttitudeSample at(const motion::Truth& truth, const sensor::Mounting& mounting) {
    auto sample = sensor::ideal_attitude(truth, mounting);
    const Eigen::Vector3d angles =
        angle_errors_.apply({*sample.roll_rad, *sample.pitch_rad, *sample.heading_rad}, truth.at);
    sample.roll_rad = std::remainder(angles.x(), circle);
    sample.pitch_rad = angles.y();
    sample.true_heading_rad = in_circle(angles.z() + error_at(truth.yaw_rad));
    sample.heading_rad = sample.true_heading_rad;
    sample.variation_rad = compass_.variation_rad;
    if (compass_.magnetic) point_magnetic(sample);
    sample.rate_of_turn_radps = turn_errors_.apply(*sample.rate_of_turn_radps, truth.at);
    return sample;
  }

  static double in_circle(double angle_rad) {
    return angle_rad - circle * std::floor(angle_rad / circle);
  }

 private:
  static constexpr double circle = 2 * std::numbers::pi;

  double error_at(double heading_rad) const {
    const auto& [constant, sine, cosine] = error_rad_;
    return constant + sine * std::sin(heading_rad) + cosine * std::cos(heading_rad);
  }

  void point_magnetic(measurement::AttitudeSample& sample) const {
    sample.reference = measurement::HeadingReference::magnetic_north;
    sample.heading_rad = in_circle(*sample.true_heading_rad - compass_.variation_rad.value_or(0));
  }

  sensor::ErrorModel angle_errors_, turn_errors_;
  rig_config::CompassConfig compass_;
  std::array<double, 3> error_rad_;
};

}  // namespace drydock::emulate
