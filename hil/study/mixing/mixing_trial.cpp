#include "hil/study/mixing/mixing_trial.hpp"

#include <cmath>
#include <string>

#include "drivers/measurement/units.hpp"
#include "estimators/mixing/mixing_accuracy.hpp"
#include "hil/motion/kinematic_trajectory.hpp"
#include "hil/sensor/imu_errors.hpp"
#include "hil/study/campaign.hpp"
#include "rig_config/load.hpp"

namespace drydock::study {
namespace {

using measurement::Stamp;

constexpr double noisy_log_sigma_mps = 0.02;

Stamp mixing_instant(double t) { return Stamp{measurement::from_seconds(t)}; }

std::string run_name(std::size_t run, std::string_view sensor) {
  return "run " + std::to_string(run) + " " + std::string(sensor);
}

}  // namespace

MixingExperiment::MixingExperiment() {
  const std::string file = "mixing-paper.toml";
  const auto mission = rig_config::load_mission_text(mixing_mission_text(), file).value();
  imu = rig_config::load_sensor_text(mixing_sensors_text(), file, rig_config::DeviceKind::imu)
            .value();
  log = rig_config::load_sensor_text(mixing_sensors_text(), file, rig_config::DeviceKind::emlog)
            .value();
  latitude_rad = mission.latitude_rad;
  heading_rad = mission.heading_rad;
  pivot_m = mission.pivot_m;

  const motion::KinematicTrajectory trajectory(mission, Stamp{});
  double north = 0, east = 0;  // on the paper's flat chart
  for (std::size_t k = 0; k < mixing_duration_s * mixing_rate_hz; ++k) {
    const double t = static_cast<double>(k) * mixing_step_s;
    const motion::Truth middle = trajectory.at(mixing_instant(t + mixing_step_s / 2));
    const double speed = middle.velocity_body.x();
    ideal.push_back({middle.specific_force, middle.angular_rate, speed, speed});
    north += middle.velocity_ned.x() * mixing_step_s;
    east += middle.velocity_ned.y() * mixing_step_s;
    if ((k + 1) % mixing_point_spacing != 0) continue;
    const motion::Truth end = trajectory.at(mixing_instant(t + mixing_step_s));
    points.push_back({north, east, -end.height_m, end.roll_rad, end.pitch_rad});
  }
}

std::vector<MixingReading> mixing_readings(const MixingExperiment& experiment, std::uint64_t seed,
                                           std::size_t run) {
  const std::string unit = run_name(run, "imu"), log_name = run_name(run, "log");
  sensor::ImuErrors imu(experiment.imu, mixing_rate_hz, seed, unit);
  sensor::ErrorModel log(experiment.log.primary, mixing_rate_hz,
                         {seed, log_name, "primary", experiment.log.fixed_bias});
  auto noise = stream_of(seed, run, "log noise");

  std::vector<MixingReading> readings;
  readings.reserve(experiment.ideal.size());
  measurement::ImuSample sample;
  for (const MixingReading& ideal : experiment.ideal) {
    sample.origin.valid_at += measurement::from_seconds(mixing_step_s);
    sample.specific_force = ideal.force;
    sample.angular_rate = ideal.rate;
    const auto read = imu.apply(sample);
    const double speed = log.apply(ideal.speed_mps, sample.origin.valid_at);
    readings.push_back({read.specific_force, read.angular_rate, speed,
                        speed + noisy_log_sigma_mps * noise.normal()});
  }
  return readings;
}

mixing::MixingOptions mixing_options(const MixingVariant& variant,
                                     const MixingExperiment& experiment) {
  mixing::MixingOptions options;
  options.type = variant.type;
  options.integral_gain = variant.integral_gain;
  options.latitude_rad = experiment.latitude_rad;
  options.heading_rad = experiment.heading_rad;
  options.pivot_m = experiment.pivot_m;
  options.accelerometer_start = false;  // "no initial attitude error"
  if (variant.as_printed) {
    options.low_pass_s = 0;
    options.sets = mixing::pointed_sets;
  }
  return options;
}

MixingOutcome mixing_run(const MixingVariant& variant, const MixingExperiment& experiment,
                         const std::vector<MixingReading>& readings) {
  mixing::MixingFilter filter(mixing_options(variant, experiment));
  mixing::MixingAccuracy accuracy({.initial_attitude_rad = 0});
  filter.start(readings[0].force, readings[0].rate, readings[0].speed_mps);
  accuracy.start(false);

  MixingOutcome outcome;
  outcome.roll_deg.reserve(mixing_points);
  outcome.pitch_deg.reserve(mixing_points);
  for (std::size_t k = 0; k < readings.size(); ++k) {
    const MixingReading& r = readings[k];
    filter.step(r.force, r.rate, variant.noisy_log ? r.noisy_speed_mps : r.speed_mps,
                mixing_step_s);
    accuracy.step(filter.gains().k1, filter.integral_gain(), filter.integral_leak(), mixing_step_s);
    if ((k + 1) % mixing_point_spacing != 0) continue;
    const auto& truth = experiment.points[outcome.roll_deg.size()];
    const double roll = filter.roll() - truth.roll_rad, pitch = filter.pitch() - truth.pitch_rad;
    outcome.roll_deg.push_back(roll / units::degree);
    outcome.pitch_deg.push_back(pitch / units::degree);
    outcome.nees += (std::pow(roll * std::cos(truth.pitch_rad), 2) + pitch * pitch) /
                    accuracy.variance() / 2 / static_cast<double>(mixing_points);
  }
  return outcome;
}

}  // namespace drydock::study
