#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "estimators/leveling/leveling_filter.hpp"
#include "estimators/pipeline/estimator.hpp"
#include "estimators/pipeline/options.hpp"

namespace drydock::pipeline {

/// The leveling filter on one IMU and one speed log. Gives an estimate for every IMU sample once it
/// runs; a speed corrects the state, and the next IMU sample shows it.
class LevelingEstimator final : public Estimator {
 public:
  /// Beyond these no underwater vehicle goes: such a sample is refused.
  static constexpr double max_specific_force_mps2 = 500;
  static constexpr double max_angular_rate_radps = 50;
  static constexpr double max_speed_mps = 100;

  /// `index` names the estimates; of `pipeline` the two time limits are used.
  LevelingEstimator(std::uint16_t index, const EstimatorOptions& options,
                    const PipelineOptions& pipeline);

  using Estimator::take;
  Outcome take(const measurement::ImuSample& sample, EstimateListener& listener) override;
  Outcome take(const measurement::WaterSpeed& speed, EstimateListener& listener) override;
  const EstimatorStatus& status() const override { return status_; }

  const leveling::LevelingFilter& filter() const { return filter_; }

 private:
  struct Speed {
    measurement::Stamp valid_at;
    double mps = 0;
  };

  bool running() const { return status_.state == EstimatorState::running; }
  bool clock_was_set_back(const measurement::ImuSample& sample);
  void stop();
  bool try_start(const measurement::ImuSample& sample);
  void step(const measurement::ImuSample& sample);
  void emit(EstimateListener& listener);

  std::uint16_t index_, imu_;
  std::optional<std::uint16_t> log_;
  bool stationary_;
  std::chrono::nanoseconds max_imu_gap_, max_speed_age_;
  leveling::LevelingFilter filter_;
  std::optional<measurement::ImuSample> last_;  ///< its valid_at is the filter's time
  std::optional<Speed> speed_;                  ///< the newest, for the next start
  int far_behind_ = 0;                          ///< samples in a row
  std::uint32_t fed_by_ = 0;                    ///< since the last start
  EstimatorStatus status_;
};

}  // namespace drydock::pipeline
