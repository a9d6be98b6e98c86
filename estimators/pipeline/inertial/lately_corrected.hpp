#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "estimators/navigation/aided_navigation.hpp"

namespace drydock::pipeline {

/// What an aiding value has changed of a navigation in the last seconds, the latest counted most.
/// If the value was wrong, the navigation is wrong by about as much. Allocates nothing.
class LatelyCorrected {
 public:
  static constexpr double span_s = 10;  ///< chosen: some times what a contradiction takes to show

  /// Calls `correct`, which corrects the navigation `dt` seconds after the call before.
  void note(navigation::AidedNavigation& navigation, double dt, auto correct) {
    const Corrected before(navigation);
    correct();
    const Corrected after(navigation);
    const double kept = std::exp(-dt / span_s);
    const Eigen::AngleAxisd turn(after.attitude * before.attitude.conjugate());
    angle_rad_ = kept * angle_rad_ + turn.angle() * turn.axis();
    velocity_mps_ = kept * velocity_mps_ + after.velocity - before.velocity;
    gyro_radps_ = kept * gyro_radps_ + after.gyro - before.gyro;
    force_mps2_ = kept * force_mps2_ + after.force - before.force;
  }

  /// Widens the navigation's covariance by what was corrected, and forgets it.
  void doubt(navigation::AidedNavigation& navigation) {
    navigation.loosen(velocity_mps_.norm(), angle_rad_.norm());
    navigation.loosen_biases(gyro_radps_.norm(), force_mps2_.norm());
    *this = {};
  }

 private:
  struct Corrected {
    explicit Corrected(const navigation::AidedNavigation& navigation)
        : attitude(navigation.state().body_to_ned),
          velocity(navigation.state().velocity_ned),
          gyro(navigation.gyro_bias()),
          force(navigation.accel_bias()) {}
    Eigen::Quaterniond attitude;
    Eigen::Vector3d velocity, gyro, force;
  };

  Eigen::Vector3d velocity_mps_ = Eigen::Vector3d::Zero(), angle_rad_ = velocity_mps_;
  Eigen::Vector3d gyro_radps_ = velocity_mps_, force_mps2_ = velocity_mps_;
};

}  // namespace drydock::pipeline
