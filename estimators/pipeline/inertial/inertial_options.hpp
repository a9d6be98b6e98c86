#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "estimators/hydrodynamics/vehicle.hpp"
#include "estimators/navigation/aided_navigation.hpp"

namespace drydock::pipeline {

/// How inertial navigation is aided: by sensors alone (kind "navigation"), or with a model of the
/// vehicle (kind "velocity"), all in one filter or as the paper has it.
enum class InertialMethod : std::uint8_t { sensors, coupled, paper };

/// A sensor that aids: its device index, and where it sits in the body frame, from the vehicle's
/// origin, m.
struct AidingSensor {
  std::uint16_t device = 0;
  Eigen::Vector3d lever = Eigen::Vector3d::Zero();
};

/// Of kinds "navigation" and "velocity". One standard deviation each.
struct InertialOptions {
  InertialMethod method = InertialMethod::sensors;

  /// Alignment: an inertial navigation knows nothing by itself. Of the vehicle's origin, at the
  /// beginning of the first IMU sample's interval; how well known, `navigation` says.
  navigation::NavigationState start;
  navigation::NavigationOptions navigation;  ///< with the gate of all aiding, gate_sigma

  double imu_period_s = 0.01;  ///< nominal
  bool imu_means = false;      ///< samples are means over the interval that they end; else instants
  Eigen::Vector3d imu_lever = Eigen::Vector3d::Zero();

  std::optional<AidingSensor> ground, log, depth, gnss;
  double depth_sigma_m = 0.5, log_sigma_mps = 0.03, ground_sigma_mps = 0.03;
  double position_sigma_m = 2, position_height_sigma_m = 4;  ///< of a fix that does not say

  double sea_level_m = 0;  ///< of the sea's surface above the ellipsoid

  // The vehicle: kind "velocity".
  std::optional<std::uint16_t> actuators;  ///< device index
  hydrodynamics::Vehicle vehicle;
  double advance_m = 0;  ///< speed that the propeller turns for = advance x rad/s
};

}  // namespace drydock::pipeline
