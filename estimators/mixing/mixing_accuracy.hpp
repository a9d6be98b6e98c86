#pragma once

#include <Eigen/Core>

namespace drydock::mixing {

/// What is known of the sensors, 1 sigma. The defaults are those of the paper's Table 5.
struct SensorAccuracy {
  double vertical_rad = 2.236e-3;       ///< constant: accelerometer bias over g, misalignment
  double gyro_bias_radps = 4.848e-5;    ///< constant; 10 deg/h
  double gyro_noise = 4.363e-4;         ///< white, rad/sqrt(s); 0.25 deg/s a sample at 100 Hz
  double initial_attitude_rad = 0.017;  ///< of a start that is not the accelerometers'
};

/// The mixing loop estimates no covariance. This is the linear loop's own answer to known sensors:
/// covariance of [attitude error, correction of the integral, vertical error, gyro bias] under the
/// gains that were used, eq. (13). What the loop does not know of the motion is not in it.
class MixingAccuracy {
 public:
  explicit MixingAccuracy(const SensorAccuracy& sensors) : sensors_(sensors) {}

  /// Begins, or begins again. `by_accelerometer`: the first attitude has the vertical's error.
  void start(bool by_accelerometer);

  /// A step under the proportional and the integral gain (1/s and 1/s2) of an integral that forgets
  /// at `leak` (1/s; 0: never).
  void step(double proportional, double integral, double leak, double dt);

  /// Of roll or of pitch, rad2; that of roll grows with 1 / cos2(pitch).
  double variance() const { return p_(0, 0); }

 private:
  SensorAccuracy sensors_;
  Eigen::Matrix4d p_ = Eigen::Matrix4d::Zero();
};

}  // namespace drydock::mixing
