#pragma once

#include <array>

#include "estimators/mixing/slip_watch.hpp"
#include "estimators/pipeline/inertial/imu_driven_estimator.hpp"
#include "estimators/pipeline/sample_noise.hpp"

namespace drydock::pipeline {

/// The mixing filter on one IMU and one speed log. Each speed holds until the next one. The
/// covariance is that of mixing::MixingAccuracy.
class MixingEstimator final : public ImuDrivenEstimator {
 public:
  MixingEstimator(Seat seat, const MixingOptions& options, const PipelineOptions& pipeline);

  const mixing::MixingFilter& filter() const { return filter_; }

 private:
  void start(const measurement::ImuSample& sample, double speed_mps) override;
  void begin(double speed_mps);
  void start_again(const measurement::ImuSample& sample, double speed_mps,
                   double silent_s) override;
  void bridge(const BridgedGap& gap) override { accuracy_.loosen_attitude(gap.angle_sigma_rad); }
  void note(const measurement::ImuSample& sample) override { noise_.add(sample); }
  bool implausible() const override { return implausible_; }
  bool blind() const override { return true; }
  void loosen_biases(double rate_sigma, double force_sigma) override;
  void step(const Eigen::Vector3d& force, const Eigen::Vector3d& rate, double dt) override;
  Correction correct(double speed_mps, bool) override {
    speed_mps_ = speed_mps;
    return {};  // the filter has no innovation: mixing.md, Outliers
  }
  void fill(AttitudeEstimate& estimate) const override;
  void judge_motion();
  void add_noise(double dt);

  mixing::MixingFilter filter_;
  mixing::MixingAccuracy accuracy_;
  double gyro_noise_;  ///< of the sensor's sheet, rad2/s
  SampleNoise noise_;
  double most_beyond_ = 0;  ///< the sheet, rad2/s, since the noise was last within it
  std::array<mixing::SlipWatch, 2> slips_;
  // Since slips_ had their last step: integrals of specific force (m/s) and rate (rad) over a time.
  Eigen::Vector3d force_sum_ = Eigen::Vector3d::Zero(), turn_sum_ = Eigen::Vector3d::Zero();
  double since_judged_s_ = 0;
  bool implausible_ = false;
  double speed_mps_ = 0;
};

}  // namespace drydock::pipeline
