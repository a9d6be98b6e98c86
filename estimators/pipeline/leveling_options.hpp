#pragma once

#include "estimators/leveling/imu_grade.hpp"
#include "estimators/leveling/leveling_filter.hpp"
#include "estimators/pipeline/aiding_sensor.hpp"
#include "estimators/pipeline/maker.hpp"

namespace drydock::pipeline {

/// A leveling filter on one IMU and one speed log.
struct LevelingOptions {
  std::optional<std::uint16_t> log;    ///< device index; needed unless stationary
  std::optional<AidingSensor> ground;  ///< a DVL that watches the IMU, lever from the IMU
  bool stationary = false;             ///< all velocities are zero; the log is not used
  leveling::FilterKind kind = leveling::FilterKind::robust;
  leveling::LevelingOptions filter;
  leveling::ImuGrade imu;  ///< for the DVL's watch; `filter` has it already
};

std::string fault_of(const LevelingOptions& options);
std::unique_ptr<Estimator> make_estimator(Seat seat, const LevelingOptions& options,
                                          const PipelineOptions& pipeline);

}  // namespace drydock::pipeline
