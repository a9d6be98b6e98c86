#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include "drivers/measurement/measurement.hpp"
#include "estimators/pipeline/pipeline.hpp"

namespace drydock::pipeline::test {

using measurement::ImuSample;
using measurement::Measurement;
using measurement::Stamp;
using measurement::WaterSpeed;
using std::chrono::milliseconds;

inline constexpr std::uint16_t imu_device = 3, log_device = 5;

inline Stamp at_ms(std::int64_t ms) { return Stamp{std::chrono::hours{24} + milliseconds{ms}}; }

inline ImuSample imu(std::int64_t ms, double turn = 0, std::uint16_t device = imu_device) {
  ImuSample sample;
  sample.origin.valid_at = sample.origin.received_at = at_ms(ms);
  sample.origin.device = device;
  sample.specific_force = {0.2, 2 * turn - 0.1, -9.8};
  sample.angular_rate = {0, 0, turn};
  return sample;
}

inline WaterSpeed water_speed(std::int64_t ms, double mps = 2, std::uint16_t device = log_device) {
  WaterSpeed speed;
  speed.origin.valid_at = speed.origin.received_at = at_ms(ms);
  speed.origin.device = device;
  speed.longitudinal_mps = mps;
  return speed;
}

/// Keeps every estimate.
struct Estimates final : EstimateListener {
  void on_attitude(const AttitudeEstimate& estimate) override { all.push_back(estimate); }
  void on_innovation(const InnovationReport& report) override { innovations.push_back(report); }
  std::vector<AttitudeEstimate> all;
  std::vector<InnovationReport> innovations;
};

inline LevelingOptions& leveling_of(PipelineOptions& options) {
  return std::get<LevelingOptions>(options.estimators[0].kind);
}

/// One leveling estimator on `imu_device` and `log_device`.
inline PipelineOptions moving(milliseconds window) {
  PipelineOptions options;
  EstimatorOptions& estimator = options.estimators.emplace_back();
  estimator.name = "attitude";
  estimator.imu = imu_device;
  auto& leveling = estimator.kind.emplace<LevelingOptions>();
  leveling.log = log_device;
  leveling.filter.latitude_rad = 0.6;
  options.reorder_window = window;
  return options;
}

}  // namespace drydock::pipeline::test
