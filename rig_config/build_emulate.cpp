#include "rig_config/build.hpp"
#include "rig_config/checks.hpp"
#include "rig_config/read_keys.hpp"

namespace drydock::rig_config {

namespace {

constexpr double degree_per_hour = degree / 3600;
constexpr double milli_g = 9.80665e-3, micro_g = 9.80665e-6;  // standard gravity, ISO 80000-3

struct ErrorKey {
  DeviceKind kind;
  const char* key;
  SensorErrors EmulateConfig::*quantity;
  std::array<double, 3> SensorErrors::*part;
  double unit;
};
using E = EmulateConfig;
using S = SensorErrors;
constexpr ErrorKey error_keys[] = {
    {DeviceKind::dvl, "velocity_bias_mps", &E::primary, &S::bias, 1},
    {DeviceKind::dvl, "velocity_noise_mps", &E::primary, &S::noise, 1},
    {DeviceKind::emlog, "speed_bias_mps", &E::primary, &S::bias, 1},
    {DeviceKind::emlog, "speed_noise_mps", &E::primary, &S::noise, 1},
    {DeviceKind::gnss, "position_noise_m", &E::primary, &S::noise, 1},
    {DeviceKind::gnss, "velocity_noise_mps", &E::secondary, &S::noise, 1},
    {DeviceKind::imu, "gyro_bias_degph", &E::primary, &S::bias, degree_per_hour},
    {DeviceKind::imu, "gyro_noise_degph", &E::primary, &S::noise, degree_per_hour},
    {DeviceKind::imu, "accelerometer_bias_mg", &E::secondary, &S::bias, milli_g},
    {DeviceKind::imu, "accelerometer_noise_ug", &E::secondary, &S::noise, micro_g},
    {DeviceKind::depth, "pressure_bias_pa", &E::primary, &S::bias, 1},
    {DeviceKind::depth, "pressure_noise_pa", &E::primary, &S::noise, 1},
};

SkyConfig build_sky(const Node& table, const std::string& rig_file) {
  SkyConfig sky;
  sky.ephemeris = beside(rig_file, table.find("ephemeris")->text);
  if (const Node* at = table.find("at")) sky.at_utc_ns = at->integer;
  read_axis(table, "antenna_axis", sky.antenna_axis);
  read(table, "boresight_cno_dbhz", sky.boresight_cno_dbhz);
  read(table, "power_noise", sky.power_noise);
  read(table, "lowest_cno_dbhz", sky.lowest_cno_dbhz);
  read(table, "elevation_mask_deg", sky.elevation_mask_rad, degree);
  return sky;
}

}  // namespace

EmulateConfig build_emulate(const Node& table, const std::string& rig_file) {
  EmulateConfig emulate;
  read(table, "fixed_bias", emulate.fixed_bias);
  read(table, "latency_ms", emulate.latency_s, millisecond);
  if (const Node* sky = table.find("sky")) emulate.sky = build_sky(*sky, rig_file);
  return emulate;
}

void read_errors(const Node& table, DeviceKind kind, EmulateConfig& into) {
  for (const ErrorKey& error : error_keys)
    if (error.kind == kind) read(table, error.key, into.*error.quantity.*error.part, error.unit);
}

}  // namespace drydock::rig_config
