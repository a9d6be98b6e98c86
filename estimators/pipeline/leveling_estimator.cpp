#include "estimators/pipeline/leveling_estimator.hpp"

#include <cmath>
#include <variant>

#include "drivers/measurement/units.hpp"

namespace drydock::pipeline {

namespace {

/// The filters with six states have no biases in their covariance: that of an accelerometer, as a
/// tilt, rad2.
double bias_variance_of(const LevelingOptions& options) {
  if (options.kind == leveling::FilterKind::augmented) return 0;
  return std::pow(options.filter.accelerometer_bias_sigma_mps2 / units::standard_gravity, 2);
}

std::optional<GroundWitness> witness_of(const LevelingOptions& options) {
  if (!options.ground) return {};
  return GroundWitness(*options.ground, options.filter, options.imu);
}

}  // namespace

std::string fault_of(const LevelingOptions& options) {
  if (!options.stationary && !options.log)
    return "a moving vehicle needs a speed log, allowed: log = a device, or stationary = true";
  return fault_of_devices({options.log});
}

std::unique_ptr<Estimator> make_estimator(Seat seat, const LevelingOptions& options,
                                          const PipelineOptions& pipeline) {
  return std::make_unique<LevelingEstimator>(seat, options, pipeline);
}

LevelingEstimator::LevelingEstimator(Seat seat, const LevelingOptions& options,
                                     const PipelineOptions& pipeline)
    : ImuDrivenEstimator(seat, options.stationary ? std::nullopt : options.log, witness_of(options),
                         pipeline),
      stationary_(options.stationary),
      bias_variance_(bias_variance_of(options)),
      filter_(leveling::make_filter(options.kind, options.filter)) {}

void LevelingEstimator::start(const measurement::ImuSample& sample, double speed_mps) {
  std::visit(
      [&](auto& filter) { filter.start(sample.specific_force, sample.angular_rate, speed_mps); },
      filter_);
}

void LevelingEstimator::start_again(const measurement::ImuSample& sample, double speed_mps,
                                    double silent_s) {
  std::visit(
      [&](auto& filter) {
        filter.start_again(sample.specific_force, sample.angular_rate, speed_mps, silent_s);
      },
      filter_);
}

void LevelingEstimator::bridge(const BridgedGap& gap) {
  std::visit([&](auto& filter) { filter.loosen(gap.velocity_sigma_mps, gap.angle_sigma_rad); },
             filter_);
}

void LevelingEstimator::loosen_biases(double rate_sigma, double force_sigma) {
  std::visit([&](auto& filter) { filter.loosen_biases(rate_sigma, force_sigma); }, filter_);
}

void LevelingEstimator::forget_innovations() {
  constraints_.clear();
  log_.clear();
  by_log_.forget();
}

void LevelingEstimator::believe_log(double change_mps) {
  std::visit([&](auto& filter) { filter.loosen_log(change_mps); }, filter_);
  log_.clear();
}

// A log that begins to contradict was wrong before that too.
template <class Filter>
void LevelingEstimator::doubt_log(Filter& filter) {
  const bool contradicts = log_.contradicts();
  if (contradicts && !log_contradicts_) by_log_.doubt(filter);
  log_contradicts_ = contradicts;
}

LevelingEstimator::Correction LevelingEstimator::correct(double speed_mps, bool trusted) {
  return std::visit(
      [&](auto& filter) {
        const LogEffect::Parts before = LogEffect::parts_of(filter);
        filter.update_moving(speed_mps, trusted);
        by_log_.add(before, LogEffect::parts_of(filter));
        const auto log = filter.innovation().log;
        log_.add(log->value / log->sigma);
        doubt_log(filter);
        return Correction{log->used, log};
      },
      filter_);
}

void LevelingEstimator::step(const Eigen::Vector3d& force, const Eigen::Vector3d& rate, double dt) {
  std::visit(
      [&](auto& filter) {
        filter.predict(force, rate, dt);
        by_log_.wait(dt);
        if (stationary_) {
          filter.update_stationary();
        } else {
          filter.update_nonholonomic(dt);
          constraints_.add(filter.constraints(), dt);
        }
      },
      filter_);
}

void LevelingEstimator::fill(AttitudeEstimate& estimate) const {
  std::visit(
      [&](const auto& filter) {
        estimate.roll_rad = filter.roll();
        estimate.pitch_rad = filter.pitch();
        estimate.covariance = filter.roll_pitch_covariance();
        estimate.covariance.diagonal().array() += bias_variance_;
      },
      filter_);
}

}  // namespace drydock::pipeline
