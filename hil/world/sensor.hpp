#pragma once

#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "rig_config/emulate.hpp"

/// `drydock sensor`: the output of an inertial unit of a grade that stands level and at rest.
namespace drydock::world {

struct SensorOptions {
  std::string grade;              ///< sensor file (TOML) with a table [imu]
  double duration_s = 7200;       ///< length of the recording
  std::optional<double> rate_hz;  ///< default: the grade's rate, else 100
  std::uint64_t seed = 1;
  bool json = false;
  std::string allan;  ///< SVG file to write; empty: none
};

/// Allan deviations at one cluster time, in the usual units of data sheets.
struct AllanRow {
  double tau_s = 0;
  std::uint64_t clusters = 0;
  rig_config::Axes gyro_degph{}, accelerometer_ug{};
};

/// Without Earth rate and with standard gravity. The last row has at least nine clusters.
std::vector<AllanRow> allan_of(const rig_config::EmulateConfig& grade, double rate_hz,
                               double duration_s, std::uint64_t seed);

/// Exit code: 0; 1 a file cannot be written; 2 the grade is wrong.
int show_sensor(const SensorOptions& options, std::FILE* out, std::FILE* errors);

}  // namespace drydock::world
