#pragma once

#include <array>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/measurement/kind.hpp"
#include "rig_config/emulate.hpp"
#include "rig_config/estimator/block.hpp"

namespace drydock::rig_config {

struct Problem;

/// What both kinds of inertial navigation have: aiding sensors, the start, and the errors of the
/// sensors. 1 sigma.
struct InertialConfig {
  std::string dvl, depth;  ///< device names
  double gate_sigma = 5, sea_level_m = 0;

  double latitude_rad = 0, longitude_rad = 0, depth_m = 0;
  std::array<double, 3> velocity_ned_mps{};
  double roll_rad = 0, pitch_rad = 0, heading_rad = 0;
  double position_sigma_m = 10, depth_sigma_m = 1, velocity_sigma_mps = 0.1;
  double tilt_sigma_rad = 0, heading_sigma_rad = 0;

  EmulateConfig imu_grade, dvl_grade, depth_grade;  ///< from the sensor file
};

InertialConfig read_inertial(const Node& table);

/// The table of the sensor file for the device of a key, and where its errors go.
struct WantedGrade {
  std::string_view key;
  measurement::Kind kind;
  EmulateConfig& into;
};

/// Reads the sensor file of the estimator for those keys that the block has.
std::vector<Problem> read_grades(const EstimatorBlock& block,
                                 std::initializer_list<WantedGrade> wanted);

}  // namespace drydock::rig_config
