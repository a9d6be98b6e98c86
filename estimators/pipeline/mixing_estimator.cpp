#include "estimators/pipeline/mixing_estimator.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/measurement/units.hpp"

namespace drydock::pipeline {

namespace {

/// 1 sigma of the acceleration of a vehicle that starts again on its way. Chosen; the same as where
/// no device tells a velocity in docs/estimators/consistency.md.
constexpr double manoeuvre_mps2 = 0.5;

/// The velocities of these times judge the attitude, s: the first sees a bias of the gyro, the
/// other a drift. Chosen.
constexpr double brief_s = 1, longer_s = 3;

/// They have a step at the pace of a log, so that they cost next to nothing: a tenth of the
/// briefer.
constexpr double judge_every_s = 0.1;

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
      accuracy_(options.sensors),
      gyro_noise_(options.sensors.gyro_noise * options.sensors.gyro_noise),
      slips_{mixing::SlipWatch(brief_s, filter_.gravity_mps2()),
             mixing::SlipWatch(longer_s, filter_.gravity_mps2())} {}

void MixingEstimator::start(const measurement::ImuSample& sample, double speed_mps) {
  filter_.start(sample.specific_force, sample.angular_rate, speed_mps);
  accuracy_.start(filter_.options().accelerometer_start);
  begin(speed_mps);
}

void MixingEstimator::start_again(const measurement::ImuSample& sample, double speed_mps, double) {
  filter_.start_by_accelerometers(sample.specific_force, sample.angular_rate, speed_mps);
  accuracy_.start(true);
  accuracy_.loosen_attitude(manoeuvre_mps2 / units::standard_gravity);
  begin(speed_mps);
}

void MixingEstimator::begin(double speed_mps) {
  speed_mps_ = speed_mps;
  noise_.forget();
  for (auto& slip : slips_) slip.start(speed_mps);
  force_sum_.setZero();
  turn_sum_.setZero();
  since_judged_s_ = 0;
  implausible_ = false;
}

void MixingEstimator::judge_motion() {
  const Eigen::Vector3d force = force_sum_ / since_judged_s_, rate = turn_sum_ / since_judged_s_;
  const double tilt_sigma = std::sqrt(std::max(accuracy_.variance_to_vertical(), 0.0));
  implausible_ = false;
  for (auto& slip : slips_) {
    slip.step(force, rate, filter_.down(), speed_mps_, since_judged_s_);
    implausible_ |= slip.contradicts(tilt_sigma);
  }
  force_sum_.setZero();
  turn_sum_.setZero();
  since_judged_s_ = 0;
}

void MixingEstimator::loosen_biases(double rate_sigma, double force_sigma) {
  accuracy_.loosen(rate_sigma, force_sigma / units::standard_gravity);
}

void MixingEstimator::step(const Eigen::Vector3d& force, const Eigen::Vector3d& rate, double dt) {
  filter_.step(force, rate, speed_mps_, dt);
  accuracy_.step(filter_.gains().k1, filter_.integral_gain(), filter_.integral_leak(), dt);
  add_noise(dt);
  force_sum_ += dt * force;
  turn_sum_ += dt * rate;
  since_judged_s_ += dt;
  if (since_judged_s_ >= judge_every_s - dt / 2) judge_motion();
}

// What is learned lags behind a noise that grows: with a gain of 1/n for each sample, the variance
// that is missing after any number of samples is n times what is learned.
void MixingEstimator::add_noise(double dt) {
  const double beyond = beyond_sheet(noise_.rate_variance() * dt, gyro_noise_);
  accuracy_.add_gyro_noise(beyond, dt);
  if (beyond > most_beyond_) {
    accuracy_.add_gyro_noise(beyond - most_beyond_, SampleNoise::samples * dt);
    most_beyond_ = beyond;
  } else if (beyond == 0) {
    most_beyond_ = 0;
  }
}

void MixingEstimator::fill(AttitudeEstimate& estimate) const {
  const double cos_pitch = std::cos(filter_.pitch());
  estimate.roll_rad = filter_.roll();
  estimate.pitch_rad = filter_.pitch();
  estimate.covariance.diagonal() << accuracy_.variance() / (cos_pitch * cos_pitch),
      accuracy_.variance();
}

}  // namespace drydock::pipeline
