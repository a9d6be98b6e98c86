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
}

bool MixingEstimator::implausible() const {
  const double tilt_sigma = std::sqrt(std::max(accuracy_.variance_to_vertical(), 0.0));
  return std::ranges::any_of(
      slips_, [&](const mixing::SlipWatch& slip) { return slip.contradicts(tilt_sigma); });
}

void MixingEstimator::loosen_biases(double rate_sigma, double force_sigma) {
  accuracy_.loosen(rate_sigma, force_sigma / units::standard_gravity);
}

void MixingEstimator::step(const Eigen::Vector3d& force, const Eigen::Vector3d& rate, double dt) {
  filter_.step(force, rate, speed_mps_, dt);
  accuracy_.step(filter_.gains().k1, filter_.integral_gain(), filter_.integral_leak(), dt);
  accuracy_.add_gyro_noise(beyond_sheet(noise_.rate_variance() * dt, gyro_noise_), dt);
  const Eigen::Vector3d down = filter_.down();
  for (auto& slip : slips_) slip.step(force, rate, down, speed_mps_, dt);
}

void MixingEstimator::fill(AttitudeEstimate& estimate) const {
  const double cos_pitch = std::cos(filter_.pitch());
  estimate.roll_rad = filter_.roll();
  estimate.pitch_rad = filter_.pitch();
  estimate.covariance.diagonal() << accuracy_.variance() / (cos_pitch * cos_pitch),
      accuracy_.variance();
}

}  // namespace drydock::pipeline
