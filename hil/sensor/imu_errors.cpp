#include "hil/sensor/imu_errors.hpp"

namespace drydock::sensor {
namespace {

ErrorSource gyro_of(const rig_config::EmulateConfig& grade, std::uint64_t seed,
                    std::string_view name, const Disturbance* fault = nullptr) {
  return {seed, name, "primary", grade.fixed_bias, fault};
}

ErrorSource accelerometer_of(const rig_config::EmulateConfig& grade, std::uint64_t seed,
                             std::string_view name, const Disturbance* fault = nullptr) {
  return {seed, name, "secondary", grade.fixed_bias, fault};
}

}  // namespace

ImuErrors::ImuErrors(const rig_config::EmulateConfig& grade, double rate_hz, std::uint64_t seed,
                     std::string_view name, const Disturbances& faults)
    : gyro_coupling_(grade.primary, gyro_of(grade, seed, name)),
      accelerometer_coupling_(grade.secondary, accelerometer_of(grade, seed, name)),
      gyro_(grade.primary, rate_hz, gyro_of(grade, seed, name, faults.gyro)),
      accelerometer_(grade.secondary, rate_hz,
                     accelerometer_of(grade, seed, name, faults.accelerometer)),
      coupled_(!gyro_coupling_.is_ideal() || !accelerometer_coupling_.is_ideal()) {}

measurement::ImuSample ImuErrors::apply(const measurement::ImuSample& ideal) {
  const Vector3d &force = ideal.specific_force, &rate = ideal.angular_rate;
  Vector3d rate_induced = Vector3d::Zero(), force_induced = Vector3d::Zero();
  if (coupled_) {
    rate_induced = gyro_coupling_.of_gyro(force);
    force_induced = accelerometer_coupling_.of_accelerometer(force, rate);
  }
  measurement::ImuSample reading = ideal;
  reading.angular_rate = gyro_.apply(rate, ideal.origin.valid_at, rate_induced);
  reading.specific_force = accelerometer_.apply(force, ideal.origin.valid_at, force_induced);
  return reading;
}

}  // namespace drydock::sensor
