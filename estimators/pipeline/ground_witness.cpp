#include "estimators/pipeline/ground_witness.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace drydock::pipeline {

using Eigen::Vector3d;

namespace {

/// One sigma of what is not known of a DVL's time of validity.
constexpr double late_s = 0.1;

/// A velocity beyond this many sigmas is not used. After so many in a row the velocity has changed,
/// not the tilt: a vehicle's velocity begins anew from the next.
constexpr double gate_sigmas = 6;
constexpr int believed_after = 5;

/// What it said last counts for so long only, and after a longer silence it begins anew.
constexpr double fresh_s = 1.2, longest_silence_s = 3;

/// P0 of the biases, worse than those of the IMU of the leveling paper, because this filter only
/// watches: 10 deg/h and 10 mg. They wander.
constexpr double rate_bias_radps = 4.8e-5, force_bias_mps2 = 0.1;
constexpr double rate_walk = 1e-6, force_walk = 1e-4;  // rad/s and m/s2, per sqrt(s)

leveling::LevelingOptions options_of(const leveling::LevelingOptions& of_estimator,
                                     const leveling::ImuGrade& imu) {
  auto options = leveling::options_for(leveling::FilterKind::augmented);
  options.latitude_rad = of_estimator.latitude_rad;
  options.height_m = of_estimator.height_m;
  options.heading_rad = of_estimator.heading_rad;
  options.gyro_bias_sigma_radps = rate_bias_radps;
  options.accelerometer_bias_sigma_mps2 = force_bias_mps2;
  return leveling::worsened(options, leveling::FilterKind::augmented, imu);
}

constexpr double squared(double x) { return x * x; }

/// Of a standard normal value: two-sided 7e-6. At five velocities a second a false alarm comes
/// about once a day, and it costs five seconds.
constexpr double mean_limit = 4.5;

}  // namespace

GroundWitness::GroundWitness(const AidingSensor& dvl, const leveling::LevelingOptions& options,
                             const leveling::ImuGrade& imu)
    : dvl_(dvl), filter_(options_of(options, imu)) {}

void GroundWitness::start(const measurement::ImuSample& sample, double rate_sigma,
                          double force_sigma) {
  filter_.start(sample.specific_force, sample.angular_rate, 0);
  loosen_biases(rate_sigma, force_sigma);
  forget();
  velocity_ = acceleration_ = Vector3d::Zero();
}

void GroundWitness::loosen(double velocity_sigma_mps, double angle_sigma_rad) {
  filter_.loosen(velocity_sigma_mps, angle_sigma_rad);
}

void GroundWitness::loosen_biases(double rate_sigma, double force_sigma) {
  filter_.loosen_biases(rate_sigma, force_sigma);
}

void GroundWitness::step(const Vector3d& force, const Vector3d& rate, double dt) {
  rate_ = rate;
  elapsed_s_ += dt;
  filter_.predict(force, rate, dt);
  filter_.loosen_biases(rate_walk * std::sqrt(dt), force_walk * std::sqrt(dt));
  const Vector3d velocity = filter_.state().head<3>();
  acceleration_ = (velocity - velocity_) / dt;
  velocity_ = velocity;
}

void GroundWitness::compare(const Vector3d& measured) {
  const Vector3d lever = dvl_.lever;
  const Vector3d velocity = measured - (rate_ - filter_.gyro_bias()).cross(lever);
  if (elapsed_s_ > longest_silence_s) forget();
  if (refused_ >= believed_after) return begin(velocity);
  std::array<double, 3> sigma{};
  bool inside = true;
  for (int i = 0; i < 3; ++i) {
    Axis& axis = axes_[static_cast<std::size_t>(i)];
    double& of_axis = sigma[static_cast<std::size_t>(i)];
    of_axis = std::sqrt(axis.noise.variance() + squared(late_s * acceleration_(i)));
    const auto innovation = filter_.update_velocity(i, velocity(i), of_axis, false);
    const double normalised = innovation.value / innovation.sigma;
    axis.noise.add(innovation.value);
    axis.window.add(normalised);
    if (!(std::abs(normalised) <= gate_sigmas)) {
      inside = false;
      continue;
    }
    axis.brief.add(normalised, elapsed_s_);
    axis.longer.add(normalised, elapsed_s_);
  }
  elapsed_s_ = 0;
  refused_ = inside ? 0 : refused_ + 1;
  if (inside) use(velocity, sigma);
}

void GroundWitness::forget() { refused_ = believed_after; }

void GroundWitness::begin(const Vector3d& velocity) {
  for (Axis& axis : axes_) axis.clear();
  filter_.loosen((velocity - filter_.state().head<3>()).norm(), 0);
  elapsed_s_ = 0;
  use(velocity, {first_noise_mps, first_noise_mps, first_noise_mps});
  refused_ = 0;
}

void GroundWitness::use(const Vector3d& velocity, const std::array<double, 3>& sigmas) {
  for (int axis = 0; axis < 3; ++axis)
    filter_.update_velocity(axis, velocity(axis), sigmas[static_cast<std::size_t>(axis)], true);
  velocity_ = filter_.state().head<3>();
}

bool GroundWitness::contradicts() const {
  return elapsed_s_ <= fresh_s && std::ranges::any_of(axes_, &Axis::contradicts);
}

void GroundWitness::Axis::clear() {
  window.clear();
  brief.clear();
  longer.clear();
}

bool GroundWitness::Axis::contradicts() const {
  const auto beyond = [](const navigation::ConstraintMean& mean) {
    return !(std::abs(mean.statistic()) <= mean_limit);  // true for NaN too
  };
  return window.contradicts() || beyond(brief) || beyond(longer);
}

}  // namespace drydock::pipeline
