#include "hil/track/setup.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/measurement/units.hpp"
#include "estimators/setup/rig_pipeline.hpp"
#include "estimators/smoothing/level_smoother.hpp"

namespace drydock::track {
namespace {

/// Of a compass that was not swung: chosen.
constexpr double heading_bias_rad = 2 * units::degree;
/// Of a DVL whose speed of sound nobody measured, 15 m/s: chosen.
constexpr double bottom_scale = 0.01;
/// Of a log that was not calibrated on a measured way: chosen.
constexpr double log_scale = 0.05;
constexpr double exact_m = 0.01;

std::vector<Eigen::Vector3d> levers_of(const rig_config::Rig& rig) {
  std::vector<Eigen::Vector3d> levers;
  for (const auto& device : rig.devices) levers.emplace_back(device.lever_arm_m.data());
  return levers;
}

InertialSetup setup_of(const rig_config::Rig& rig, const pipeline::EstimatorOptions& estimator,
                       const pipeline::InertialOptions& from) {
  InertialSetup setup;
  setup.estimator = estimator.name;
  setup.imu = estimator.imu;
  setup.options = {.start = from.start,
                   .navigation = from.navigation,
                   .imu_means = from.imu_means,
                   .imu_lever = from.imu_lever,
                   .levers = levers_of(rig),
                   .sea_level_m = from.sea_level_m};
  setup.bottom_sigma_mps = from.ground_sigma_mps;
  setup.depth_sigma_m = from.depth_sigma_m;
  setup.heading_sigma_rad = from.heading_sigma_rad;
  setup.fix_sigma_m = from.position_sigma_m;
  return setup;
}

}  // namespace

std::optional<InertialSetup> inertial_of(const rig_config::Rig& rig) {
  for (const auto& estimator : setup::pipeline_options(rig).estimators)
    if (const auto* inertial = std::get_if<pipeline::InertialOptions>(&estimator.kind))
      return setup_of(rig, estimator, *inertial);
  return {};
}

bool has(const smoothing::Dive& dive, smoothing::Quantity quantity) {
  return std::ranges::find(dive.readings, quantity, &smoothing::Reading::quantity) !=
         dive.readings.end();
}

bool tells_height(const smoothing::Dive& dive) {
  return std::ranges::any_of(dive.readings, [](const smoothing::Reading& reading) {
    return reading.quantity == smoothing::Quantity::depth ||
           reading.quantity == smoothing::Quantity::bottom ||
           (reading.quantity == smoothing::Quantity::fix && std::isfinite(reading.value.z()));
  });
}

smoothing::LevelOptions level_of(const Gathered& gathered, const frame::Position& origin) {
  smoothing::LevelOptions options;
  options.start = smoothing::level_start(gathered.dive, origin);
  options.sigmas.heading_bias_rad = heading_bias_rad;
  options.sigmas.bottom_scale = bottom_scale;
  options.sigmas.log_scale = log_scale;
  options.fix_heights = !has(gathered.dive, smoothing::Quantity::depth);
  if (!has(gathered.dive, smoothing::Quantity::fix)) options.sigmas.position_m = exact_m;
  if (!has(gathered.dive, smoothing::Quantity::log)) {
    options.sigmas.current_mps = 0;
    options.motion.current_mps = 0;
  }
  for (const auto& lever : levers_of(gathered.rig)) options.sensors.push_back({.lever = lever});
  return options;
}

}  // namespace drydock::track
