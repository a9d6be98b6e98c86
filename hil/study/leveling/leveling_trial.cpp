#include "hil/study/leveling/leveling_trial.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <string>
#include <variant>

#include "drivers/measurement/units.hpp"
#include "estimators/leveling/any_leveling_filter.hpp"
#include "hil/sensor/errors.hpp"
#include "hil/study/campaign.hpp"

namespace drydock::study {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr double dt = 1 / leveling_rate_hz;
constexpr auto steps = static_cast<std::size_t>(leveling_duration_s * leveling_rate_hz);
constexpr auto steps_a_point =
    static_cast<std::size_t>(leveling_point_spacing_s * leveling_rate_hz);

/// The errors of Table 1, without biases for LevelingBiases::none.
rig_config::SensorErrors table_1(double bias, double noise, LevelingBiases biases) {
  if (biases == LevelingBiases::none) bias = 0;
  rig_config::SensorErrors errors;
  errors.bias = {bias, bias, bias};
  errors.noise = {noise, noise, noise};
  return errors;
}

class LevelingScore {
 public:
  LevelingScore(const LevelingMotion& motion, LevelingOutcome& outcome)
      : motion_(motion), outcome_(outcome) {}

  template <class Filter>
  void note(const Filter& filter, std::size_t step) {
    const double t = static_cast<double>(step) * dt;
    const auto truth = motion_.attitude(t);
    error_ = {frame::wrap_pi(filter.roll() - truth.roll) / units::degree,
              frame::wrap_pi(filter.pitch() - truth.pitch) / units::degree};
    if (error_.cwiseAbs().maxCoeff() >= 0.5) outcome_.settled_s = t;
    if (step % steps_a_point != 0) return;
    covariance_ = filter.roll_pitch_covariance() / (units::degree * units::degree);
    outcome_.roll_error.push_back(error_.x());
    outcome_.pitch_error.push_back(error_.y());
    outcome_.roll_variance.push_back(covariance_(0, 0));
    outcome_.pitch_variance.push_back(covariance_(1, 1));
  }

  void finish() {
    outcome_.nees = error_.dot(covariance_.inverse() * error_) / 2;
    outcome_.diverged = error_.cwiseAbs().maxCoeff() > 5;
  }

 private:
  const LevelingMotion& motion_;
  LevelingOutcome& outcome_;
  Vector2d error_ = Vector2d::Zero();  ///< roll, pitch, deg
  Eigen::Matrix2d covariance_ = Eigen::Matrix2d::Identity();
};

template <class Filter>
LevelingOutcome follow(const LevelingTrial& trial, const std::vector<LevelingReading>& readings,
                       Filter& filter) {
  LevelingOutcome outcome;
  LevelingScore score(trial.motion, outcome);
  const auto& first = readings.front();
  filter.start(first.specific_force, first.angular_rate, trial.stationary ? 0 : first.speed_mps);
  score.note(filter, 0);
  for (std::size_t i = 0; i < readings.size(); ++i) {
    filter.predict(readings[i].specific_force, readings[i].angular_rate, dt);
    if (trial.stationary) {
      filter.update_stationary();
    } else {
      filter.update_nonholonomic(dt);
      filter.update_moving(readings[i].speed_mps);
    }
    score.note(filter, i + 1);
  }
  score.finish();
  return outcome;
}

}  // namespace

std::vector<LevelingReading> leveling_readings(const LevelingTrial& trial) {
  const std::string run = "run " + std::to_string(trial.run);
  const bool fixed = trial.biases == LevelingBiases::one_sigma;
  const double hour = 3600;
  const auto model = [&](double bias, double noise, std::string_view quantity) {
    return sensor::ErrorModel(table_1(bias, noise, trial.biases), 1 / dt,
                              {trial.seed, run, quantity, fixed});
  };
  auto gyro = model(units::degree / hour, 0.3 * units::degree / hour, "gyro");
  auto accelerometer =
      model(1e-3 * units::standard_gravity, 50e-6 * units::standard_gravity, "accelerometer");
  auto log = model(0.1, 0.1, "log");

  std::vector<LevelingReading> readings;
  readings.reserve(steps);
  for (std::size_t i = 0; i < steps; ++i) {
    const double t = static_cast<double>(i) * dt;
    const auto ideal = trial.motion.reading(t, dt, leveling_latitude_rad);
    const measurement::Stamp at{measurement::from_seconds(t)};
    readings.push_back({accelerometer.apply(ideal.specific_force, at),
                        gyro.apply(ideal.angular_rate, at), log.apply(ideal.speed_mps, at)});
  }
  return readings;
}

LevelingOutcome run_leveling(const LevelingTrial& trial,
                             const std::vector<LevelingReading>& readings,
                             leveling::FilterKind kind, leveling::LevelingOptions options) {
  const auto guess_error = [&](std::string_view angle) {
    return 45 * units::degree * stream_of(trial.seed, trial.run, angle).normal();
  };
  const auto truth = trial.motion.attitude(0);
  options.latitude_rad = leveling_latitude_rad;
  options.heading_rad = truth.yaw;
  options.initial_roll_rad = truth.roll + guess_error("initial roll");
  options.initial_pitch_rad = truth.pitch + guess_error("initial pitch");
  auto any = leveling::make_filter(kind, options);
  return std::visit([&](auto& filter) { return follow(trial, readings, filter); }, any);
}

}  // namespace drydock::study
