#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "estimators/hydrodynamics/vehicle.hpp"
#include "estimators/navigation/aided_navigation.hpp"
#include "estimators/pipeline/aiding_sensor.hpp"
#include "estimators/pipeline/maker.hpp"

namespace drydock::pipeline {

/// The aiding of the inertial navigation: sensors alone, or with a model of the vehicle, either all
/// in one filter (`coupled`) or as in the paper (`paper`).
enum class InertialMethod : std::uint8_t { sensors, coupled, paper };

/// An inertial navigation with its aiding sensors. All sigmas are one standard deviation.
struct InertialOptions {
  InertialMethod method = InertialMethod::sensors;

  /// Alignment: the state of the origin of the vehicle at the begin of the interval of the first
  /// IMU sample. An inertial navigation cannot find it by itself. `navigation` has its uncertainty.
  navigation::NavigationState start;
  navigation::NavigationOptions navigation;  ///< gate_sigma is the gate of all aiding sensors

  double imu_period_s = 0.01;  ///< nominal
  bool imu_means = false;  ///< true: means over the interval before valid_at; false: at valid_at
  Eigen::Vector3d imu_lever = Eigen::Vector3d::Zero();

  std::optional<AidingSensor> ground, log, depth, gnss, heading;
  double depth_sigma_m = 0.5, log_sigma_mps = 0.03, ground_sigma_mps = 0.03;
  double position_sigma_m = 2, position_height_sigma_m = 4;  ///< of a fix without accuracy

  double heading_sigma_rad = 0.0175;  ///< 1 degree, a common compass

  double sea_level_m = 0;  ///< height of the sea surface above the ellipsoid

  // The vehicle, for the methods with a model of it.
  std::optional<std::uint16_t> actuators;  ///< device index
  hydrodynamics::Vehicle vehicle;
  double advance_m = 0;  ///< commanded speed = advance x propeller rate in rad/s
};

std::string fault_of(const InertialOptions& options);
std::unique_ptr<Estimator> make_estimator(Seat seat, const InertialOptions& options,
                                          const PipelineOptions& pipeline);

}  // namespace drydock::pipeline
