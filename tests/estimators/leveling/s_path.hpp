#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <random>

#include "estimators/frame/attitude.hpp"
#include "estimators/frame/earth.hpp"

/// Motion, sensor errors and initial errors of the paper's simulations, Table 1 and chapter 4. The
/// code comes from the paper's equations (12)-(17) and uses nothing of the filter.
namespace drydock::leveling::test {

using Eigen::Vector3d;

inline constexpr double degree = std::numbers::pi / 180;
inline constexpr double latitude = 36 * degree;
inline constexpr double rate_hz = 100;
inline constexpr double dt = 1 / rate_hz;

struct Reading {
  Vector3d specific_force, angular_rate;
  double speed;
};

/// A vehicle with constant roll and pitch whose heading is A sin(2 pi t / T); A = 0: straight.
struct SPath {
  double speed = 10, amplitude = 45 * degree, period = 30;
  double roll = 0, pitch = 0, heading = 0;

  /// The readings of perfect sensors over [t, t + dt]: the values in the middle of the interval.
  Reading at(double t) const {
    const double w = 2 * std::numbers::pi / period, middle = t + dt / 2;
    const frame::Euler attitude{roll, pitch, heading + amplitude * std::sin(w * middle)};
    const Vector3d rate_nb =
        frame::body_rate(attitude, {0, 0, amplitude * w * std::cos(w * middle)});
    const Eigen::Matrix3d to_body = frame::ned_to_body(attitude);
    const Vector3d earth = to_body * frame::earth_rate_ned(latitude);
    const Vector3d rate_ib = rate_nb + earth, velocity{speed, 0, 0};
    const Vector3d gravity = to_body * Vector3d{0, 0, frame::gravity(latitude)};
    return {(rate_ib + earth).cross(velocity) - gravity, rate_ib, speed};
  }
};

/// The errors of Table 1: biases as given, white noise per sample.
class Table1Sensors {
 public:
  explicit Table1Sensors(unsigned seed) : engine_(seed) {}

  void fix_biases_at_one_sigma() {
    gyro_bias_.setConstant(gyro_bias_sigma);
    accelerometer_bias_.setConstant(accelerometer_bias_sigma);
    speed_bias_ = speed_bias_sigma;
  }

  void draw_biases() {
    gyro_bias_ = gyro_bias_sigma * white();
    accelerometer_bias_ = accelerometer_bias_sigma * white();
    speed_bias_ = speed_bias_sigma * normal_(engine_);
  }

  Reading operator()(const Reading& truth) {
    return {truth.specific_force + accelerometer_bias_ + 50e-6 * 9.80665 * white(),
            truth.angular_rate + gyro_bias_ + 0.3 * degree / 3600 * white(),
            truth.speed + speed_bias_ + 0.1 * normal_(engine_)};
  }

  double normal() { return normal_(engine_); }

 private:
  static constexpr double gyro_bias_sigma = degree / 3600;
  static constexpr double accelerometer_bias_sigma = 1e-3 * 9.80665;
  static constexpr double speed_bias_sigma = 0.1;

  Vector3d white() {
    const double x = normal_(engine_), y = normal_(engine_), z = normal_(engine_);
    return {x, y, z};
  }

  std::mt19937_64 engine_;
  std::normal_distribution<double> normal_;
  Vector3d gyro_bias_ = Vector3d::Zero(), accelerometer_bias_ = Vector3d::Zero();
  double speed_bias_ = 0;
};

}  // namespace drydock::leveling::test
