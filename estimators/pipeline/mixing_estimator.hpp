#pragma once

#include "estimators/pipeline/inertial/imu_driven_estimator.hpp"

namespace drydock::pipeline {

/// The mixing filter on one IMU and one speed log. Each speed holds until the next one. The
/// covariance is that of mixing::MixingAccuracy.
class MixingEstimator final : public ImuDrivenEstimator {
 public:
  MixingEstimator(Seat seat, const MixingOptions& options, const PipelineOptions& pipeline);

  const mixing::MixingFilter& filter() const { return filter_; }

 private:
  void start(const measurement::ImuSample& sample, double speed_mps) override;
  void start_again(const measurement::ImuSample& sample, double speed_mps,
                   double silent_s) override;
  bool blind() const override { return true; }
  void loosen_biases(double rate_sigma, double force_sigma) override;
  void step(const Eigen::Vector3d& force, const Eigen::Vector3d& rate, double dt) override;
  Correction correct(double speed_mps, bool) override {
    speed_mps_ = speed_mps;
    return {};  // the filter has no innovation: mixing.md, Outliers
  }
  void fill(AttitudeEstimate& estimate) const override;

  mixing::MixingFilter filter_;
  mixing::MixingAccuracy accuracy_;
  double speed_mps_ = 0;
};

}  // namespace drydock::pipeline
