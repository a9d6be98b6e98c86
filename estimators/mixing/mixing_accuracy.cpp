#include "estimators/mixing/mixing_accuracy.hpp"

namespace drydock::mixing {

void MixingAccuracy::start(bool by_accelerometer) {
  const auto squared = [](double x) { return x * x; };
  p_.setZero();
  p_(2, 2) = squared(sensors_.vertical_rad);
  p_(3, 3) = squared(sensors_.gyro_bias_radps);
  if (by_accelerometer) {
    p_(0, 0) = p_(0, 2) = p_(2, 0) = p_(2, 2);
  } else {
    p_(0, 0) = squared(sensors_.initial_attitude_rad);
  }
}

void MixingAccuracy::loosen(double gyro_bias_sigma, double vertical_sigma) {
  p_(2, 2) += vertical_sigma * vertical_sigma;
  p_(3, 3) += gyro_bias_sigma * gyro_bias_sigma;
}

void MixingAccuracy::step(double proportional, double integral, double leak, double dt) {
  // Eq. (13): d(error) = bias + K1 (vertical - error) + correction, d(correction) = KI (vertical -
  // error) - leak correction. The vertical error and the bias are constant.
  Eigen::Matrix4d transition = Eigen::Matrix4d::Identity();
  transition.row(0) += dt * Eigen::RowVector4d{-proportional, 1, proportional, 1};
  transition.row(1) += dt * Eigen::RowVector4d{-integral, -leak, integral, 0};
  p_ = (transition * p_ * transition.transpose()).eval();
  p_(0, 0) += sensors_.gyro_noise * sensors_.gyro_noise * dt;
}

}  // namespace drydock::mixing
