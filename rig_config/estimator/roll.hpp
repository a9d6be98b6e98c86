#pragma once

#include <array>
#include <string>
#include <vector>

#include "rig_config/estimator/facts.hpp"

namespace drydock::rig_config {

struct Node;

/// The antenna, receiver and gyro of a roll estimator. All sigmas are one standard deviation.
/// docs/estimators/roll.md
struct RollConfig {
  static constexpr std::array devices{DeviceKey{"gnss", measurement::Kind::gnss}};
  static constexpr EstimatorFacts facts{.name = "roll", .devices = devices, .has_gate = true};

  std::string gnss;                             ///< device name
  std::array<double, 3> antenna_axis{0, 0, 1};  ///< boresight, unit vector in the body frame
  double boresight_cno_dbhz = 48;
  double lowest_cno_dbhz = 20;            ///< the lowest C/N0 that the receiver reports
  double cno_resolution_db = 1;           ///< on the wire
  double power_noise = 0.1;               ///< of the power at each epoch, relative to boresight
  double angular_random_walk = 1.745e-4;  ///< of the roll gyro, rad per sqrt(s): 0.6 deg/sqrt(h)
  double gyro_bias_radps = 0.0174532925199433;
  double angle_of_attack_rad = 0.00872664625997165;  ///< between body x and the velocity
};

void read_kind(const Node& table, RollConfig& into);

/// None: the signals of satellites have no rows of innovations.
std::vector<std::string> compared_devices(const RollConfig& config);

}  // namespace drydock::rig_config
