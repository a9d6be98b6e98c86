#include "estimators/pipeline/mixing_estimator.hpp"

#include <cmath>

#include "drivers/measurement/units.hpp"

namespace drydock::pipeline {

namespace {

/// 1 sigma of the acceleration of a vehicle that starts again on its way. Chosen; the same as where
/// no device tells a velocity in docs/estimators/consistency.md.
constexpr double manoeuvre_mps2 = 0.5;

std::optional<GroundWitness> witness_of(const MixingOptions& options) {
  if (!options.ground) return {};
  return GroundWitness(
      *options.ground,
      {.latitude_rad = options.filter.latitude_rad, .heading_rad = options.filter.heading_rad},
      options.imu);
}

}  // namespace

std::string fault_of(const MixingOptions& options) {
  if (!options.log) return "mixing needs a speed log, allowed: log = a device";
  return fault_of_devices({options.log});
}

std::unique_ptr<Estimator> make_estimator(Seat seat, const MixingOptions& options,
                                          const PipelineOptions& pipeline) {
  return std::make_unique<MixingEstimator>(seat, options, pipeline);
}

MixingEstimator::MixingEstimator(Seat seat, const MixingOptions& options,
                                 const PipelineOptions& pipeline)
    : ImuDrivenEstimator(seat, options.log, witness_of(options), pipeline),
      filter_(options.filter),
      accuracy_(options.sensors) {}

void MixingEstimator::start(const measurement::ImuSample& sample, double speed_mps) {
  filter_.start(sample.specific_force, sample.angular_rate, speed_mps);
  accuracy_.start(filter_.options().accelerometer_start);
  speed_mps_ = speed_mps;
}

void MixingEstimator::start_again(const measurement::ImuSample& sample, double speed_mps, double) {
  filter_.start_by_accelerometers(sample.specific_force, sample.angular_rate, speed_mps);
  accuracy_.start(true);
  accuracy_.loosen_attitude(manoeuvre_mps2 / units::standard_gravity);
  speed_mps_ = speed_mps;
}

void MixingEstimator::loosen_biases(double rate_sigma, double force_sigma) {
  accuracy_.loosen(rate_sigma, force_sigma / units::standard_gravity);
}

void MixingEstimator::step(const Eigen::Vector3d& force, const Eigen::Vector3d& rate, double dt) {
  filter_.step(force, rate, speed_mps_, dt);
  accuracy_.step(filter_.gains().k1, filter_.integral_gain(), filter_.integral_leak(), dt);
}

void MixingEstimator::fill(AttitudeEstimate& estimate) const {
  const double cos_pitch = std::cos(filter_.pitch());
  estimate.roll_rad = filter_.roll();
  estimate.pitch_rad = filter_.pitch();
  estimate.covariance.diagonal() << accuracy_.variance() / (cos_pitch * cos_pitch),
      accuracy_.variance();
}

}  // namespace drydock::pipeline
