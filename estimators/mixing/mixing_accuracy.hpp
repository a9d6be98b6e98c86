#pragma once

#include <Eigen/Core>

namespace drydock::mixing {

/// Errors of the sensors, 1 sigma. The defaults are those of Table 5 of the paper.
struct SensorAccuracy {
  double vertical_rad = 2.236e-3;       ///< constant: accelerometer bias over g, misalignment
  double gyro_bias_radps = 4.848e-5;    ///< constant; 10 deg/h
  double gyro_noise = 4.363e-4;         ///< white, rad/sqrt(s); 0.25 deg/s a sample at 100 Hz
  double initial_attitude_rad = 0.017;  ///< of a start without accelerometers
};

/// The mixing loop estimates no covariance. This class computes one from the errors of the sensors
/// and the gains in use, for the linear loop: covariance of [attitude error, correction of the
/// integral, vertical error, gyro bias], eq. (13). It does not contain errors from unmodelled
/// motion.
class MixingAccuracy {
 public:
  explicit MixingAccuracy(const SensorAccuracy& sensors) : sensors_(sensors) {}

  /// Starts or restarts. `by_accelerometer`: the first attitude has the error of the vertical.
  void start(bool by_accelerometer);

  /// One step with the proportional and the integral gain (1/s and 1/s2). The integral decays at
  /// the rate `leak` (1/s; 0: never).
  void step(double proportional, double integral, double leak, double dt);

  /// The gyro's noise over `dt` was more than that of the sensor: by this variance, rad2/s.
  void add_gyro_noise(double beyond, double dt) { p_(0, 0) += beyond * dt; }

  /// The gyro bias (rad/s) and the error of the vertical (rad) may have changed by these sigmas.
  void loosen(double gyro_bias_sigma, double vertical_sigma);

  /// The attitude may have changed by this sigma, rad.
  void loosen_attitude(double sigma) { p_(0, 0) += sigma * sigma; }

  /// Variance of pitch, rad2. The variance of roll is this divided by cos2(pitch).
  double variance() const { return p_(0, 0); }
  /// Likewise against the vertical of the accelerometers, which the loop cannot tell from its own.
  double variance_to_vertical() const { return p_(0, 0) - 2 * p_(0, 2) + p_(2, 2); }

 private:
  SensorAccuracy sensors_;
  Eigen::Matrix4d p_ = Eigen::Matrix4d::Zero();
};

}  // namespace drydock::mixing
