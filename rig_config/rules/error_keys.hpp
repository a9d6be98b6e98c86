#pragma once

#include "drivers/measurement/units.hpp"
#include "rig_config/emulate.hpp"
#include "rig_config/rig.hpp"

/// Maps each key of a sensor file to a figure of docs/sensors/errors.md and its unit.
namespace drydock::rig_config {

struct ErrorKey {
  DeviceKind kind;
  const char* key;
  SensorErrors EmulateConfig::*quantity;
  Axes SensorErrors::*part;
  double unit;  ///< one unit of the key in SI
};

struct CorrelationKey {
  DeviceKind kind;
  const char* key;
  SensorErrors EmulateConfig::*quantity;
};

namespace keys {

using units::degree, units::degree_per_hour, units::milli_g, units::micro_g;
using units::revolution_per_minute, units::standard_gravity;
inline constexpr double root_hour = 60;  // in s^(1/2)
inline constexpr double ppm = 1e-6, milliradian = 1e-3;
using enum measurement::Kind;
using S = SensorErrors;
inline constexpr auto primary = &EmulateConfig::primary, secondary = &EmulateConfig::secondary;

inline constexpr ErrorKey error_keys[] = {
    {imu, "gyro_bias_degph", primary, &S::bias, degree_per_hour},
    {imu, "gyro_scale_factor_ppm", primary, &S::scale_factor, ppm},
    {imu, "gyro_asymmetry_ppm", primary, &S::asymmetry, ppm},
    {imu, "gyro_nonlinearity_ppmpdegps", primary, &S::nonlinearity, ppm / degree},
    {imu, "gyro_misalignment_mrad", primary, &S::misalignment, milliradian},
    {imu, "gyro_mass_unbalance_degphpg", primary, &S::sensitivity,
     degree_per_hour / standard_gravity},
    {imu, "gyro_anisoelasticity_degphpg2", primary, &S::anisoelasticity,
     degree_per_hour / (standard_gravity * standard_gravity)},
    {imu, "gyro_noise_degph", primary, &S::noise, degree_per_hour},
    {imu, "gyro_angle_random_walk_degprth", primary, &S::noise_density, degree / root_hour},
    {imu, "gyro_bias_instability_degph", primary, &S::bias_instability, degree_per_hour},
    {imu, "gyro_rate_random_walk_degphprth", primary, &S::random_walk, degree_per_hour / root_hour},
    {imu, "gyro_range_degps", primary, &S::range, degree},
    {imu, "gyro_quantisation_degps", primary, &S::quantisation, degree},

    {imu, "accelerometer_bias_mg", secondary, &S::bias, milli_g},
    {imu, "accelerometer_scale_factor_ppm", secondary, &S::scale_factor, ppm},
    {imu, "accelerometer_asymmetry_ppm", secondary, &S::asymmetry, ppm},
    {imu, "accelerometer_nonlinearity_ugpg2", secondary, &S::nonlinearity, 1e-6 / standard_gravity},
    {imu, "accelerometer_misalignment_mrad", secondary, &S::misalignment, milliradian},
    {imu, "accelerometer_rate_sensitivity_ugpdegps", secondary, &S::sensitivity, micro_g / degree},
    {imu, "accelerometer_anisoelasticity_ugpg2", secondary, &S::anisoelasticity,
     1e-6 / standard_gravity},
    {imu, "accelerometer_noise_ug", secondary, &S::noise, micro_g},
    {imu, "accelerometer_velocity_random_walk_ugprthz", secondary, &S::noise_density, micro_g},
    {imu, "accelerometer_bias_instability_ug", secondary, &S::bias_instability, micro_g},
    {imu, "accelerometer_random_walk_ugprth", secondary, &S::random_walk, micro_g / root_hour},
    {imu, "accelerometer_range_g", secondary, &S::range, standard_gravity},
    {imu, "accelerometer_quantisation_ug", secondary, &S::quantisation, micro_g},

    {dvl, "velocity_bias_mps", primary, &S::bias, 1},
    {dvl, "velocity_scale_factor_ppm", primary, &S::scale_factor, ppm},
    {dvl, "velocity_misalignment_mrad", primary, &S::misalignment, milliradian},
    {dvl, "velocity_noise_mps", primary, &S::noise, 1},
    {dvl, "velocity_bias_instability_mps", primary, &S::bias_instability, 1},
    {dvl, "velocity_range_mps", primary, &S::range, 1},
    {dvl, "velocity_quantisation_mps", primary, &S::quantisation, 1},

    {emlog, "speed_bias_mps", primary, &S::bias, 1},
    {emlog, "speed_scale_factor_ppm", primary, &S::scale_factor, ppm},
    {emlog, "speed_asymmetry_ppm", primary, &S::asymmetry, ppm},
    {emlog, "speed_misalignment_mrad", primary, &S::misalignment, milliradian},
    {emlog, "speed_noise_mps", primary, &S::noise, 1},
    {emlog, "speed_bias_instability_mps", primary, &S::bias_instability, 1},
    {emlog, "speed_range_mps", primary, &S::range, 1},
    {emlog, "speed_quantisation_mps", primary, &S::quantisation, 1},

    {gnss, "position_bias_m", primary, &S::bias, 1},
    {gnss, "position_noise_m", primary, &S::noise, 1},
    {gnss, "position_bias_instability_m", primary, &S::bias_instability, 1},
    {gnss, "velocity_noise_mps", secondary, &S::noise, 1},
    {gnss, "velocity_bias_instability_mps", secondary, &S::bias_instability, 1},

    {depth, "pressure_bias_pa", primary, &S::bias, 1},
    {depth, "pressure_scale_factor_ppm", primary, &S::scale_factor, ppm},
    {depth, "pressure_noise_pa", primary, &S::noise, 1},
    {depth, "pressure_bias_instability_pa", primary, &S::bias_instability, 1},
    {depth, "pressure_random_walk_paprth", primary, &S::random_walk, 1 / root_hour},
    {depth, "pressure_range_pa", primary, &S::range, 1},
    {depth, "pressure_quantisation_pa", primary, &S::quantisation, 1},

    {actuator, "angle_bias_deg", primary, &S::bias, degree},
    {actuator, "angle_scale_factor_ppm", primary, &S::scale_factor, ppm},
    {actuator, "angle_noise_deg", primary, &S::noise, degree},
    {actuator, "angle_quantisation_deg", primary, &S::quantisation, degree},
    {actuator, "shaft_bias_rpm", secondary, &S::bias, revolution_per_minute},
    {actuator, "shaft_scale_factor_ppm", secondary, &S::scale_factor, ppm},
    {actuator, "shaft_noise_rpm", secondary, &S::noise, revolution_per_minute},
    {actuator, "shaft_quantisation_rpm", secondary, &S::quantisation, revolution_per_minute},

    {attitude, "attitude_bias_deg", primary, &S::bias, degree},
    {attitude, "attitude_noise_deg", primary, &S::noise, degree},
    {attitude, "attitude_bias_instability_deg", primary, &S::bias_instability, degree},
    {attitude, "attitude_quantisation_deg", primary, &S::quantisation, degree},
    {attitude, "turn_bias_degps", secondary, &S::bias, degree},
    {attitude, "turn_scale_factor_ppm", secondary, &S::scale_factor, ppm},
    {attitude, "turn_noise_degps", secondary, &S::noise, degree},
    {attitude, "turn_quantisation_degps", secondary, &S::quantisation, degree},
};

inline constexpr CorrelationKey correlation_keys[] = {
    {imu, "gyro_correlation_s", primary},       {imu, "accelerometer_correlation_s", secondary},
    {dvl, "velocity_correlation_s", primary},   {emlog, "speed_correlation_s", primary},
    {gnss, "position_correlation_s", primary},  {gnss, "velocity_correlation_s", secondary},
    {depth, "pressure_correlation_s", primary}, {attitude, "attitude_correlation_s", primary}};

}  // namespace keys

using keys::correlation_keys, keys::error_keys;

}  // namespace drydock::rig_config
