#include "estimators/leveling/earth_rate.hpp"

#include <cmath>

#include "estimators/frame/earth.hpp"

namespace drydock::leveling {

EarthRate::EarthRate(double latitude_rad)
    : given_(frame::earth_rate_ned(latitude_rad)), expected_(given_) {}

void EarthRate::forget_heading(double sigma_rad) {
  forgotten_variance_ += sigma_rad * sigma_rad;
  expect();
}

double EarthRate::drift(double gyro_bias_sigma_radps, double dt) {
  const double before = variance_;
  drift_rad_ += gyro_bias_sigma_radps * dt;
  expect();
  return variance_ - before;
}

void EarthRate::expect() {
  const double heading_variance = forgotten_variance_ + drift_rad_ * drift_rad_;
  const double kept = std::exp(-heading_variance / 2);  // mean cosine of a normal angle
  expected_.x() = kept * given_.x();
  variance_ = given_.x() * given_.x() * (1 - kept * kept) / 2;
}

}  // namespace drydock::leveling
