#include <algorithm>
#include <cmath>

#include "drivers/measurement/units.hpp"
#include "drivers/measurement/water_column.hpp"
#include "estimators/frame/attitude.hpp"
#include "estimators/setup/options_of.hpp"
#include "estimators/setup/sensor_grade.hpp"
#include "estimators/vehicle/vehicle.hpp"

namespace drydock::setup {
namespace {

using Eigen::Vector3d;
using rig_config::SensorErrors;

std::optional<pipeline::AidingSensor> aiding(const rig_config::Rig& rig, const std::string& name) {
  const auto* device = find_device(rig, name);
  if (!device) return {};
  return pipeline::AidingSensor{index_of(rig, name).value(), Vector3d{device->lever_arm_m.data()}};
}

/// Standard deviation of one sample: white noise and quantisation.
double sample_sigma(const SensorErrors& errors, double rate_hz) {
  return std::hypot(worst(errors.noise), worst(errors.noise_density) * std::sqrt(rate_hz),
                    worst(errors.quantisation) / std::sqrt(12));
}

/// If the sensor file does not give the noise of a sensor, the figure of the paper stays.
void replace_if_known(double& sigma, double known) {
  if (known > 0) sigma = known;
}

navigation::NavigationState start_of(const rig_config::InertialConfig& c) {
  navigation::NavigationState start;
  start.position = {c.latitude_rad, c.longitude_rad, c.sea_level_m - c.depth_m};
  start.velocity_ned = Vector3d{c.velocity_ned_mps.data()};
  start.body_to_ned = frame::body_to_ned({c.roll_rad, c.pitch_rad, c.heading_rad});
  return start;
}

navigation::NavigationOptions navigation_options(const rig_config::InertialConfig& c,
                                                 double imu_period_s) {
  navigation::NavigationOptions options;
  options.position_m = c.position_sigma_m;
  options.height_m = c.depth_sigma_m;
  options.velocity_mps = c.velocity_sigma_mps;
  options.alignment_rad = {c.tilt_sigma_rad, c.tilt_sigma_rad, c.heading_sigma_rad};
  const SensorErrors &gyro = c.imu_grade.primary, &accelerometer = c.imu_grade.secondary;
  // The filter models a constant bias. Its sigma must also cover the bias instability.
  options.gyro_bias_radps = std::hypot(worst(gyro.bias), worst(gyro.bias_instability));
  options.accel_bias_mps2 =
      std::hypot(worst(accelerometer.bias), worst(accelerometer.bias_instability));
  options.angle_noise_rad = density(gyro, imu_period_s);
  options.velocity_noise_mps = density(accelerometer, imu_period_s);
  options.gyro_bias_walk_radps = worst(gyro.random_walk);
  options.accel_bias_walk_mps2 = worst(accelerometer.random_walk);
  options.gate_sigma = c.gate_sigma;
  return options;
}

/// What both kinds have: IMU, start, DVL and depth sensor.
pipeline::InertialOptions inertial_options(const rig_config::InertialConfig& c,
                                           const EstimatorInRig& place) {
  const rig_config::Rig& rig = place.rig;
  pipeline::InertialOptions options;
  if (const auto* imu = find_device(rig, place.estimator.imu)) {
    options.imu_period_s = 1 / imu->rate_hz;
    options.imu_means = imu->means;
    options.imu_lever = Vector3d{imu->lever_arm_m.data()};
  }
  options.start = start_of(c);
  options.navigation = navigation_options(c, options.imu_period_s);
  options.sea_level_m = c.sea_level_m;
  options.ground = aiding(rig, c.dvl);
  options.depth = aiding(rig, c.depth);
  if (const auto* dvl = find_device(rig, c.dvl))
    replace_if_known(options.ground_sigma_mps, sample_sigma(c.dvl_grade.primary, dvl->rate_hz));
  if (const auto* depth = find_device(rig, c.depth)) {
    const double pascal_per_metre = depth->water_density_kgm3 * units::standard_gravity;
    replace_if_known(options.depth_sigma_m,
                     sample_sigma(c.depth_grade.primary, depth->rate_hz) / pascal_per_metre);
  }
  return options;
}

}  // namespace

pipeline::InertialOptions options_of(const rig_config::NavigationConfig& config,
                                     const EstimatorInRig& place) {
  pipeline::InertialOptions options = inertial_options(config.inertial, place);
  options.gnss = aiding(place.rig, config.gnss);
  options.heading = aiding(place.rig, config.heading);
  if (const auto* compass = find_device(place.rig, config.heading))
    replace_if_known(options.heading_sigma_rad,
                     sample_sigma(config.heading_grade.primary, compass->rate_hz));
  return options;
}

pipeline::InertialOptions options_of(const rig_config::VelocityConfig& config,
                                     const EstimatorInRig& place) {
  using pipeline::InertialMethod;
  pipeline::InertialOptions options = inertial_options(config.inertial, place);
  options.method = config.method == rig_config::VelocityMethod::paper ? InertialMethod::paper
                                                                      : InertialMethod::coupled;
  options.log = aiding(place.rig, config.log);
  if (const auto* log = find_device(place.rig, config.log))
    replace_if_known(options.log_sigma_mps, sample_sigma(config.log_grade.primary, log->rate_hz));
  options.actuators = index_of(place.rig, config.actuators);
  if (config.vehicle) {
    options.vehicle = vehicle::dimensional(*config.vehicle);
    options.advance_m = config.vehicle->propeller.advance_m;
  }
  return options;
}

}  // namespace drydock::setup
