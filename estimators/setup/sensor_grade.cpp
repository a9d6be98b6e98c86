#include "estimators/setup/sensor_grade.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/measurement/units.hpp"

namespace drydock::setup {
namespace {

using rig_config::SensorErrors;

/// What stays as a bias while the vehicle keeps its attitude: the other errors act on gravity.
double bias_under_gravity(const SensorErrors& errors, double per_gravity) {
  const double gravity = units::standard_gravity;
  const double constant = std::hypot(worst(errors.bias), worst(errors.bias_instability));
  const double by_gravity =
      std::hypot(per_gravity, worst(errors.anisoelasticity) * gravity) * gravity;
  return std::hypot(constant, by_gravity);
}

double share(const SensorErrors& errors) {
  return std::hypot(worst(errors.misalignment), worst(errors.scale_factor),
                    worst(errors.asymmetry));
}

/// A Gauss-Markov bias wanders at first as this random walk.
double walk(const SensorErrors& errors) {
  return std::hypot(worst(errors.random_walk),
                    worst(errors.bias_instability) * std::sqrt(2 / errors.correlation_s));
}

}  // namespace

double worst(const rig_config::Axes& axes) { return *std::ranges::max_element(axes); }

double density(const SensorErrors& errors, double period_s) {
  return std::hypot(worst(errors.noise) * std::sqrt(period_s), worst(errors.noise_density));
}

leveling::ImuGrade imu_grade(const EstimatorInRig& place) {
  const auto* device = find_device(place.rig, place.estimator.imu);
  if (!device) return {};
  const SensorErrors &gyro = device->emulate.primary, &force = device->emulate.secondary;
  const double period_s = 1 / device->rate_hz;
  return {.angle_noise_rad = density(gyro, period_s),
          .velocity_noise_mps = density(force, period_s),
          .gyro_bias_radps = bias_under_gravity(gyro, worst(gyro.sensitivity)),
          .accelerometer_bias_mps2 = bias_under_gravity(force, share(force)),
          .gyro_bias_walk_radps = walk(gyro),
          .accelerometer_bias_walk_mps2 = walk(force),
          .rate_share = share(gyro)};
}

}  // namespace drydock::setup
