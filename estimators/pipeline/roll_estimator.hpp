#pragma once

#include <optional>

#include "estimators/pipeline/estimator.hpp"
#include "estimators/pipeline/gyro_angle.hpp"
#include "estimators/pipeline/options.hpp"
#include "estimators/roll/all_satellites.hpp"

namespace drydock::pipeline {

/// The roll filter on one IMU, of which it takes the roll gyro, and one satellite receiver: its
/// velocity for the axis, its satellites' C/N0 for the roll. Gives an estimate for every IMU sample
/// once it runs; pitch and yaw are those of the velocity.
class RollEstimator final : public Estimator {
 public:
  static constexpr double max_angular_rate_radps = 50;
  static constexpr double max_speed_mps = 1e4;

  /// `index` names the estimates; of `pipeline` the two time limits are used, the one for speeds
  /// for fixes.
  RollEstimator(std::uint16_t index, const EstimatorOptions& options,
                const PipelineOptions& pipeline);

  using Estimator::take;
  Outcome take(const measurement::ImuSample& sample, EstimateListener& listener) override;
  Outcome take(const measurement::GnssFix& fix, EstimateListener& listener) override;
  Outcome take(const measurement::GnssSatellites& sky, EstimateListener& listener) override;
  const EstimatorStatus& status() const override { return status_; }

  const roll::AllSatellites& filter() const { return filter_; }

 private:
  struct Axis {
    measurement::Stamp valid_at;
    roll::FlightPath path;
    double sigma_rad = 0;
  };
  struct Height {
    measurement::Stamp valid_at;
    double metres = 0;
    std::optional<double> down_mps;  ///< since the height before
  };

  bool clock_was_set_back(const measurement::ImuSample& sample);
  void stop();
  std::optional<Eigen::Vector3d> velocity_of(const measurement::GnssFix& fix);
  bool knows_axis(measurement::Stamp at) const;
  void emit(EstimateListener& listener);

  std::uint16_t index_, imu_, gnss_;
  RollOptions options_;
  std::chrono::nanoseconds max_imu_gap_, max_fix_age_;
  roll::AllSatellites filter_;
  GyroAngle gyro_;
  measurement::Stamp last_{};     ///< IMU sample: the filter's time, once gyro_ has one
  std::optional<Axis> axis_;      ///< of the newest fix
  std::optional<Height> height_;  ///< of the last climb; where there is no vertical velocity
  int far_behind_ = 0;            ///< IMU samples in a row
  std::uint32_t fed_by_ = 0;      ///< since the last start
  EstimatorStatus status_;
};

}  // namespace drydock::pipeline
