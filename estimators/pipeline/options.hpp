#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "estimators/pipeline/external_options.hpp"
#include "estimators/pipeline/inertial/inertial_options.hpp"
#include "estimators/pipeline/integrity.hpp"
#include "estimators/pipeline/leveling_options.hpp"
#include "estimators/pipeline/mixing_options.hpp"
#include "estimators/pipeline/reckoning/reckoning_options.hpp"
#include "estimators/pipeline/roll_options.hpp"
#include "estimators/pipeline/vehicle_limits.hpp"

namespace drydock::pipeline {

/// The options of every kind of estimator. Checks and makers: maker.hpp.
using EstimatorKind = std::variant<LevelingOptions, MixingOptions, RollOptions, InertialOptions,
                                   ReckoningOptions, ExternalOptions>;

/// One estimator of the rig. Its index in `PipelineOptions::estimators` names its estimates.
struct EstimatorOptions {
  std::string name;
  std::uint16_t imu = 0;  ///< device index, as in Origin::device; of a kind without an IMU: any
  EstimatorKind kind;
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
  VehicleLimits vehicle;
  AlertLimits alert;
};

}  // namespace drydock::pipeline
