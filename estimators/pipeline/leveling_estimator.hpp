#pragma once

#include "estimators/leveling/any_leveling_filter.hpp"
#include "estimators/pipeline/inertial/imu_driven_estimator.hpp"

namespace drydock::pipeline {

/// A leveling filter on one IMU and one speed log.
class LevelingEstimator final : public ImuDrivenEstimator {
 public:
  LevelingEstimator(Seat seat, const LevelingOptions& options, const PipelineOptions& pipeline);

  const leveling::AnyLevelingFilter& filter() const { return filter_; }

 private:
  void start(const measurement::ImuSample& sample, double speed_mps) override;
  void start_again(const measurement::ImuSample& sample, double speed_mps,
                   double silent_s) override;
  void bridge(const BridgedGap& gap) override;
  void step(const Eigen::Vector3d& force, const Eigen::Vector3d& rate, double dt) override;
  Correction correct(double speed_mps) override;
  void fill(AttitudeEstimate& estimate) const override;

  bool stationary_;
  leveling::AnyLevelingFilter filter_;
};

}  // namespace drydock::pipeline
