#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "estimators/leveling/leveling_filter.hpp"
#include "estimators/mixing/mixing_accuracy.hpp"
#include "estimators/mixing/mixing_filter.hpp"
#include "estimators/pipeline/inertial/inertial_options.hpp"
#include "estimators/roll/hypothesis.hpp"

namespace drydock::pipeline {

/// Options of kind "roll".
struct RollOptions {
  roll::AllSatellitesOptions filter;  ///< the next two give antenna.tracking_limit
  double boresight_cno_dbhz = 48;     ///< C/N0 of a satellite on the boresight of the antenna
  double lowest_cno_dbhz = 20;        ///< the lowest C/N0 that the receiver reports
  double axis_sigma_rad = 0.01;       ///< between body x and the velocity: angle of attack
  double least_speed_mps = 20;        ///< below it the velocity does not give the axis
};

/// One estimator of the rig. Its index in `PipelineOptions::estimators` names its estimates.
struct EstimatorOptions {
  std::string name;
  std::string kind = "leveling";     ///< or "mixing", "roll", "navigation", "velocity"
  std::uint16_t imu = 0;             ///< device index, as in Origin::device
  std::optional<std::uint16_t> log;  ///< device index; needed unless stationary
  bool stationary = false;           ///< all velocities are zero; the log is not used
  leveling::FilterKind filter = leveling::FilterKind::robust;
  leveling::LevelingOptions leveling;
  mixing::MixingOptions mixing;
  mixing::SensorAccuracy mixing_sensors;
  std::optional<std::uint16_t> gnss;  ///< device index; kind "roll" needs it
  RollOptions roll;
  InertialOptions inertial;  ///< kinds "navigation" and "velocity"
};

struct PipelineOptions {
  std::vector<EstimatorOptions> estimators;

  /// How long a measurement waits for older ones. 0: no measurement waits.
  std::chrono::nanoseconds reorder_window = std::chrono::milliseconds{200};
  /// Number of measurements that can wait at once. When it is full, the oldest is used early.
  std::size_t reorder_capacity = 1024;
  /// A longer gap between two samples of an IMU restarts its estimator.
  std::chrono::nanoseconds max_imu_gap = std::chrono::milliseconds{500};
  /// The largest difference, older or newer, between a used speed and the time of the estimator.
  std::chrono::nanoseconds max_speed_age = std::chrono::milliseconds{500};
};

}  // namespace drydock::pipeline
