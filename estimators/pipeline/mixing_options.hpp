#pragma once

#include "estimators/leveling/imu_grade.hpp"
#include "estimators/mixing/mixing_accuracy.hpp"
#include "estimators/mixing/mixing_filter.hpp"
#include "estimators/pipeline/aiding_sensor.hpp"
#include "estimators/pipeline/maker.hpp"

namespace drydock::pipeline {

/// The mixing filter on one IMU and one speed log.
struct MixingOptions {
  std::optional<std::uint16_t> log;    ///< device index; needed
  std::optional<AidingSensor> ground;  ///< a DVL that watches the IMU, lever from the IMU
  mixing::MixingOptions filter;
  mixing::SensorAccuracy sensors;
  leveling::ImuGrade imu;  ///< for the DVL's watch
};

std::string fault_of(const MixingOptions& options);
std::unique_ptr<Estimator> make_estimator(Seat seat, const MixingOptions& options,
                                          const PipelineOptions& pipeline);

}  // namespace drydock::pipeline
