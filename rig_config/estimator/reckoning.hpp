#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "rig_config/estimator/facts.hpp"

namespace drydock::rig_config {

struct Node;

/// Position from speed and heading, without an IMU. All sigmas are one standard deviation.
/// docs/estimators/dead-reckoning.md
struct ReckoningConfig {
  static constexpr std::array devices{
      DeviceKey{"dvl", measurement::Kind::dvl}, DeviceKey{"log", measurement::Kind::emlog},
      DeviceKey{"heading", measurement::Kind::attitude},
      DeviceKey{"depth", measurement::Kind::depth}, DeviceKey{"gnss", measurement::Kind::gnss}};
  static constexpr EstimatorFacts facts{.name = "dead-reckoning",
                                        .devices = devices,
                                        .gives_positions = true,
                                        .has_innovations = true,
                                        .has_imu = false};

  std::string dvl, log, heading, depth, gnss;  ///< device names
  double sea_level_m = 0;                      ///< above the ellipsoid

  std::optional<double> latitude_rad, longitude_rad;  ///< of the start; empty: the first fix
  double depth_m = 0;
  double variation_rad = 0;  ///< true minus magnetic heading
  double position_sigma_m = 10, depth_sigma_m = 0.5;
  double heading_sigma_rad = 0.0174532925199433, tilt_sigma_rad = 0.0174532925199433;
  double scale_sigma = 0.005;           ///< of the DVL's speed
  double current_sigma_mps = 0.2;       ///< of the water, each of north and east
  double velocity_sigma_mps = 0.02;     ///< of a speed of the DVL
  double water_speed_sigma_mps = 0.05;  ///< of a speed of the log
  double wander_mps_per_root_s = 0.1;   ///< of the speed between two samples
  double gap_s = 5;                     ///< a longer time without speed or heading is a gap
};

void read_kind(const Node& table, ReckoningConfig& into);

/// The receiver: its fixes are compared with the track.
std::vector<std::string> compared_devices(const ReckoningConfig& config);

}  // namespace drydock::rig_config
