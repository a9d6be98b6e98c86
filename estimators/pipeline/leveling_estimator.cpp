#include "estimators/pipeline/leveling_estimator.hpp"

namespace drydock::pipeline {

LevelingEstimator::LevelingEstimator(std::uint16_t index, const EstimatorOptions& options,
                                     const PipelineOptions& pipeline)
    : ImuDrivenEstimator(index, options, pipeline),
      stationary_(options.stationary),
      filter_(options.leveling) {}

void LevelingEstimator::start(const measurement::ImuSample& sample, double speed_mps) {
  filter_.start(sample.specific_force, sample.angular_rate, speed_mps);
}

void LevelingEstimator::step(const Eigen::Vector3d& force, const Eigen::Vector3d& rate, double dt) {
  filter_.predict(force, rate, dt);
  if (stationary_) {
    filter_.update_stationary();
  } else {
    filter_.update_nonholonomic(dt);
  }
}

void LevelingEstimator::fill(AttitudeEstimate& estimate) const {
  estimate.roll_rad = filter_.roll();
  estimate.pitch_rad = filter_.pitch();
  estimate.covariance = filter_.roll_pitch_covariance();
}

}  // namespace drydock::pipeline
