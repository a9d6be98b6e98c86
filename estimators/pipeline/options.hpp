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

namespace drydock::pipeline {

/// One estimator of the rig. Its index in `PipelineOptions::estimators` names its estimates.
struct EstimatorOptions {
  std::string name;
  std::string kind = "leveling";     ///< or "mixing"
  std::uint16_t imu = 0;             ///< device index, as in Origin::device
  std::optional<std::uint16_t> log;  ///< device index; needed unless stationary
  bool stationary = false;           ///< all velocities are zero; the log is not used
  leveling::FilterKind filter = leveling::FilterKind::robust;
  leveling::LevelingOptions leveling;
  mixing::MixingOptions mixing;
  mixing::SensorAccuracy mixing_sensors;
};

struct PipelineOptions {
  std::vector<EstimatorOptions> estimators;

  /// How long a measurement may wait for an older one. 0: nothing waits.
  std::chrono::nanoseconds reorder_window = std::chrono::milliseconds{200};
  /// Most measurements that wait at once; when full, the oldest goes on early.
  std::size_t reorder_capacity = 1024;
  /// A longer gap between two samples of an IMU starts its estimator again.
  std::chrono::nanoseconds max_imu_gap = std::chrono::milliseconds{500};
  /// A speed is used while it is at most this far, either way, from its estimator's time.
  std::chrono::nanoseconds max_speed_age = std::chrono::milliseconds{500};
};

}  // namespace drydock::pipeline
