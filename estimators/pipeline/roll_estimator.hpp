#pragma once

#include <optional>

#include "estimators/pipeline/estimator.hpp"
#include "estimators/pipeline/fix_timing.hpp"
#include "estimators/pipeline/gyro_angle.hpp"
#include "estimators/pipeline/options.hpp"
#include "estimators/pipeline/rate_gate.hpp"
#include "estimators/pipeline/rate_leap.hpp"
#include "estimators/pipeline/trust.hpp"
#include "estimators/roll/all_satellites.hpp"

namespace drydock::pipeline {

/// The roll filter on the roll gyro of one IMU and one satellite receiver. The velocity of the
/// receiver gives the axis, the C/N0 of the satellites gives the roll. While it runs it gives an
/// estimate for every IMU sample; pitch and yaw are those of the velocity.
class RollEstimator final : public Estimator {
 public:
  static constexpr double max_angular_rate_radps = 50;
  static constexpr double max_speed_mps = 1e4;

  /// From `pipeline` it uses only the two time limits; the one for speeds applies to fixes.
  RollEstimator(Seat seat, const RollOptions& options, const PipelineOptions& pipeline);

  using Estimator::take;
  Outcome take(const measurement::ImuSample& sample, EstimateListener& listener) override;
  Outcome take(const measurement::GnssFix& fix, EstimateListener& listener) override;
  Outcome take(const measurement::GnssSatellites& sky, EstimateListener& listener) override;
  void doubt(std::uint16_t device, bool doubted) override {
    if (device == imu_) imu_doubted_ = doubted;
    if (device == gnss_) gnss_doubted_ = doubted;
  }
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
    std::optional<double> down_mps;  ///< since the previous height
  };

  bool clock_was_set_back(const measurement::ImuSample& sample);
  void stop();
  std::optional<Eigen::Vector3d> velocity_of(const measurement::GnssFix& fix);
  bool knows_axis(measurement::Stamp at) const;
  void judge();
  void emit(EstimateListener& listener);
  Integrity integrity_of(const AttitudeEstimate& estimate, double known_variance) const;

  std::uint16_t index_, imu_, gnss_;
  RollOptions options_;
  std::chrono::nanoseconds max_imu_gap_, max_fix_age_;
  AlertLimits alert_;
  measurement::Stamp epoch_{};  ///< the last one that was used
  roll::AllSatellites filter_;
  RateGate gate_;
  RateLeap leap_;
  FixTiming timing_;
  Trust trust_;  ///< of the satellites in the roll, and of findings in its devices
  bool imu_doubted_ = false, gnss_doubted_ = false;  ///< by a finding
  std::optional<measurement::Stamp> contradicted_;   ///< the last time that the signals did
  int contradictions_ = 0;                           ///< in a row
  GyroAngle gyro_;
  measurement::Stamp last_{};  ///< last IMU sample and time of the filter; valid if gyro_ has one
  std::optional<Axis> axis_;   ///< from the newest fix
  std::optional<Height> height_;  ///< for fixes without a vertical velocity
  int far_behind_ = 0;            ///< IMU samples in a row from the past
  std::uint32_t fed_by_ = 0;      ///< devices since the last start
  EstimatorStatus status_;
};

}  // namespace drydock::pipeline
