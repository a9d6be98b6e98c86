#include "hil/study/velocity/velocity_errors.hpp"

#include <boost/random/normal_distribution.hpp>
#include <cmath>

#include "estimators/frame/local_earth.hpp"
#include "hil/study/campaign.hpp"

namespace drydock::study {

using Eigen::Vector3d;

namespace {

navigation::NavigationState wrong_start(const MissionInstant& truth, const VelocityErrors& errors,
                                        sensor::RandomStream random) {
  navigation::NavigationOptions sigma;
  sigma.position_m = errors.position_m;
  sigma.height_m = errors.height_m;
  sigma.velocity_mps = errors.velocity_mps;
  sigma.alignment_rad = errors.alignment_rad;
  const auto scale = navigation::initial_sigma(sigma, truth.position);
  const auto draw = [&](int first) -> Vector3d {
    return scale.segment<3>(first).cwiseProduct(random.normal3());
  };
  navigation::Sdins start({truth.position, truth.velocity_ned, truth.body_to_ned});
  const Vector3d position = draw(0), velocity = draw(3), phi = draw(6);
  start.correct(-position, -velocity, -phi);
  return start.state();
}

/// A random stream with the interface that Boost.Random needs.
struct Bits {
  using result_type = std::uint64_t;
  static constexpr result_type min() { return 0; }
  static constexpr result_type max() { return ~result_type{}; }
  result_type operator()() { return stream.next(); }
  sensor::RandomStream& stream;
};

}  // namespace

MeasuredMission::MeasuredMission(const RecordedMission& mission, const VelocityErrors& errors,
                                 bool gaps, std::uint64_t seed, std::size_t run)
    : mission_(mission),
      errors_(errors),
      gaps_(gaps),
      random_(stream_of(seed, run, "noise")),
      start_(wrong_start(mission.instants.front(), errors, stream_of(seed, run, "start"))) {
  auto constants = stream_of(seed, run, "constants");
  gyro_bias_ = errors.gyro_bias_radps * constants.normal3();
  accel_bias_ = errors.accel_bias_mps2 * constants.normal3();
  gyro_scale_ = Vector3d::Ones() + errors.scale * constants.normal3();
  accel_scale_ = Vector3d::Ones() + errors.scale * constants.normal3();
  log_scale_ = 1 + errors.log_scale * constants.normal();
  log_bias_ = errors.log_bias_mps * constants.normal();
}

void MeasuredMission::measure(std::size_t step, MeasuredStep& out) {
  constexpr double dt = RecordedMission::sample_s;
  const double angle_noise = errors_.angle_noise_rad * std::sqrt(dt);
  const double velocity_noise = errors_.velocity_noise_mps * std::sqrt(dt);
  const auto noise = [&](double sigma) -> Vector3d {
    const double x = normal(), y = normal();
    return {sigma * x, sigma * y, sigma * normal()};
  };
  out.mean_height_m = 0;
  for (std::size_t i = 0; i < MeasuredStep::samples; ++i) {
    const MissionSample& truth = mission_.samples[step * MeasuredStep::samples + i];
    out.angle[i] = truth.angle.cwiseProduct(gyro_scale_) + gyro_bias_ * dt + noise(angle_noise);
    out.velocity[i] =
        truth.velocity.cwiseProduct(accel_scale_) + accel_bias_ * dt + noise(velocity_noise);
    out.height_m[i] = truth.height_m + errors_.depth_m * normal();
    out.mean_height_m += out.height_m[i] / MeasuredStep::samples;
    out.control[i] = truth.control;
  }
  const MissionInstant& truth = mission_.instants[step + 1];
  const std::size_t tenths = step + 1;
  out.log_mps.reset();
  out.ground.reset();
  if (tenths % 5 == 0)
    out.log_mps = log_scale_ * truth.speed_through_water + log_bias_ + errors_.log_mps * normal();
  if (tenths % 10 == 0) {
    const Vector3d white = noise(errors_.ground_mps);
    const bool sees_the_bed = gaps_ ? tenths / 6000 % 2 == 0 : tenths <= 36000;
    if (sees_the_bed) out.ground = truth.velocity_body() + white;
  }
}

double MeasuredMission::normal() {
  // A ziggurat. A run draws fourteen million numbers; logarithms would take a tenth of the study's
  // time.
  Bits bits{random_};
  return boost::random::normal_distribution<double>{}(bits);
}

}  // namespace drydock::study
