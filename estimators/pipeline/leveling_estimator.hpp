#pragma once

#include "estimators/leveling/any_leveling_filter.hpp"
#include "estimators/navigation/innovation_window.hpp"
#include "estimators/pipeline/constraint_watch.hpp"
#include "estimators/pipeline/inertial/imu_driven_estimator.hpp"
#include "estimators/pipeline/log_effect.hpp"

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
  void loosen_biases(double rate_sigma, double force_sigma) override;
  void step(const Eigen::Vector3d& force, const Eigen::Vector3d& rate, double dt) override;
  bool contradicted() const override { return constraints_.contradict(); }
  bool log_contradicted() const override { return log_.contradicts(); }
  void forget_innovations() override;
  void believe_log(double change_mps) override;
  Correction correct(double speed_mps, bool trusted) override;
  template <class Filter>
  void doubt_log(Filter& filter);
  void fill(AttitudeEstimate& estimate) const override;

  bool stationary_;
  ConstraintWatch constraints_;
  navigation::InnovationWindow log_;
  LogEffect by_log_;
  bool log_contradicts_ = false;
  double bias_variance_;  ///< of roll and pitch, rad2: what the filter has no states for
  leveling::AnyLevelingFilter filter_;
};

}  // namespace drydock::pipeline
