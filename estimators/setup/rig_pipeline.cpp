#include "estimators/setup/rig_pipeline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "drivers/measurement/stamp.hpp"
#include "estimators/setup/inertial_options.hpp"

namespace drydock::setup {
namespace {

std::uint16_t index_of(const rig_config::Rig& rig, const std::string& name) {
  const auto it = std::find_if(rig.devices.begin(), rig.devices.end(),
                               [&](const auto& device) { return device.name == name; });
  return static_cast<std::uint16_t>(it - rig.devices.begin());
}

leveling::FilterKind filter_kind(rig_config::LevelingFilter filter) {
  switch (filter) {
    case rig_config::LevelingFilter::augmented: return leveling::FilterKind::augmented;
    case rig_config::LevelingFilter::paper: return leveling::FilterKind::paper;
    case rig_config::LevelingFilter::robust: break;
  }
  return leveling::FilterKind::robust;
}

mixing::MixingOptions mixing_options(const rig_config::EstimatorConfig& config) {
  using enum mixing::MixingType;
  constexpr std::array types{compensated, fixed_gain, fuzzy_inference, gain_schedule};
  mixing::MixingOptions options;
  options.type = types.at(static_cast<std::size_t>(config.mixing_type));
  options.latitude_rad = config.latitude_rad;
  options.heading_rad = config.heading_rad;
  options.accelerometer_start = config.accelerometer_start;
  options.initial_roll_rad = config.initial_roll_rad;
  options.initial_pitch_rad = config.initial_pitch_rad;
  options.pivot_m = config.pivot_m;
  return options;
}

pipeline::RollOptions roll_options(const rig_config::RollConfig& config) {
  pipeline::RollOptions roll;
  roll.boresight_cno_dbhz = config.boresight_cno_dbhz;
  roll.lowest_cno_dbhz = config.lowest_cno_dbhz;
  roll.axis_sigma_rad = config.angle_of_attack_rad;
  roll.filter.gyro_noise = config.angular_random_walk;
  roll.filter.bias_sigma_radps = config.gyro_bias_radps;
  roll.filter.antenna.boresight_body = Eigen::Vector3d{config.antenna_axis.data()};
  roll.filter.antenna.noise = config.power_noise;
  roll.filter.antenna.resolution_db = config.cno_resolution_db;
  return roll;
}

}  // namespace

pipeline::PipelineOptions pipeline_options(const rig_config::Rig& rig) {
  pipeline::PipelineOptions options;
  options.reorder_window = measurement::from_seconds(rig.reorder_window_s);
  for (const auto& config : rig.estimators) {
    pipeline::EstimatorOptions estimator;
    estimator.name = config.name;
    estimator.kind = config.kind;
    estimator.imu = index_of(rig, config.imu);
    if (!config.log.empty()) estimator.log = index_of(rig, config.log);
    if (!config.gnss.empty()) estimator.gnss = index_of(rig, config.gnss);
    estimator.stationary = config.stationary;
    estimator.filter = filter_kind(config.filter);
    estimator.leveling = leveling::options_for(estimator.filter);
    estimator.leveling.latitude_rad = config.latitude_rad;
    estimator.leveling.heading_rad = config.heading_rad;
    estimator.leveling.accelerometer_start = config.accelerometer_start;
    estimator.leveling.initial_roll_rad = config.initial_roll_rad;
    estimator.leveling.initial_pitch_rad = config.initial_pitch_rad;
    estimator.mixing = mixing_options(config);
    estimator.roll = roll_options(config.roll);
    if (config.kind == "navigation" || config.kind == "velocity")
      estimator.inertial = inertial_options(rig, config);
    options.estimators.push_back(std::move(estimator));
  }
  return options;
}

std::vector<std::string> pipeline_notes(const rig_config::Rig& rig,
                                        const pipeline::Pipeline& pipeline) {
  std::vector<std::string> notes;
  const auto& counters = pipeline.counters();
  for (std::size_t i = 0; i < std::min(counters.size(), rig.devices.size()); ++i) {
    const pipeline::DeviceCounters& c = counters[i];
    if (c.late == 0 && c.refused == 0) continue;
    notes.push_back(fmt::format("{}: of {} measurements {} too late for the estimators, {} refused",
                                rig.devices[i].name, c.received, c.late, c.refused));
  }
  for (std::size_t i = 0; i < std::min(pipeline.estimators(), rig.estimators.size()); ++i) {
    const auto& status = pipeline.status(i);
    if (status.rejected > 0)
      notes.push_back(
          fmt::format("{}: {} values outside its gate", rig.estimators[i].name, status.rejected));
    if (status.lost_at)
      notes.push_back(fmt::format(
          "{}: lost after {} estimates, when its IMU fell silent for more than {} s; it needs a "
          "new start",
          rig.estimators[i].name, status.estimates,
          measurement::seconds(pipeline::PipelineOptions{}.max_imu_gap)));
  }
  if (pipeline.overflows() > 0) {
    notes.push_back(fmt::format("reorder buffer full: {} measurements used before their turn",
                                pipeline.overflows()));
  }
  return notes;
}

}  // namespace drydock::setup
