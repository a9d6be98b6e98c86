#include "estimators/smoothing/singer.hpp"

#include <cmath>

namespace drydock::smoothing {
namespace {

/// Below it the closed form loses its digits, and the first terms of its series are exact enough.
constexpr double short_step = 0.02;

/// For a sigma of 1 and times in units of the correlation time.
Eigen::Matrix3d noise_over(double x) {
  Eigen::Matrix3d q;
  if (x < short_step) {
    const double x2 = x * x, x3 = x2 * x;
    q << x3 * x2 / 10, x2 * x2 / 4, x3 / 3, x2 * x2 / 4, 2 * x3 / 3, x2, x3 / 3, x2, 2 * x;
    return q;
  }
  const double once = std::exp(-x), twice = once * once;
  q(0, 0) = 1 - twice + 2 * x + 2 * x * x * x / 3 - 2 * x * x - 4 * x * once;
  q(0, 1) = q(1, 0) = twice + 1 - 2 * once + 2 * x * once - 2 * x + x * x;
  q(0, 2) = q(2, 0) = 1 - twice - 2 * x * once;
  q(1, 1) = 4 * once - 3 - twice + 2 * x;
  q(1, 2) = q(2, 1) = twice + 1 - 2 * once;
  q(2, 2) = 1 - twice;
  return q;
}

}  // namespace

double singer_acceleration(double density, double correlation_s) {
  return density / std::sqrt(2 * correlation_s);
}

SingerStep singer_step(double density, double correlation_s, double dt) {
  const double x = dt / correlation_s;
  const double lost = -std::expm1(-x);  // of the acceleration
  const double to_value = x < short_step ? x * x / 2 * (1 - x / 3) : x - lost;
  SingerStep step;
  step.transition << 1, dt, correlation_s * correlation_s * to_value,  //
      0, 1, correlation_s * lost,                                      //
      0, 0, 1 - lost;
  const Eigen::Vector3d scale = singer_acceleration(density, correlation_s) *
                                Eigen::Vector3d(correlation_s * correlation_s, correlation_s, 1);
  step.noise = scale.asDiagonal() * noise_over(x) * scale.asDiagonal();
  return step;
}

}  // namespace drydock::smoothing
