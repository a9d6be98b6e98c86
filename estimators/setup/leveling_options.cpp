#include "estimators/setup/options_of.hpp"
#include "estimators/setup/sensor_grade.hpp"

namespace drydock::setup {
namespace {

leveling::FilterKind filter_kind(rig_config::LevelingFilter filter) {
  switch (filter) {
    case rig_config::LevelingFilter::augmented: return leveling::FilterKind::augmented;
    case rig_config::LevelingFilter::paper: return leveling::FilterKind::paper;
    case rig_config::LevelingFilter::robust: break;
  }
  return leveling::FilterKind::robust;
}

}  // namespace

pipeline::LevelingOptions options_of(const rig_config::LevelingConfig& config,
                                     const EstimatorInRig& place) {
  pipeline::LevelingOptions options;
  options.log = index_of(place.rig, config.log);
  options.ground = witness_of(place);
  options.imu = imu_grade(place);
  options.stationary = config.stationary;
  options.kind = filter_kind(config.filter);
  options.filter =
      leveling::worsened(leveling::options_for(options.kind), options.kind, options.imu);
  options.filter.latitude_rad = config.start.latitude_rad;
  options.filter.heading_rad = config.start.heading_rad;
  options.filter.accelerometer_start = config.start.accelerometer;
  options.filter.initial_roll_rad = config.start.initial_roll_rad;
  options.filter.initial_pitch_rad = config.start.initial_pitch_rad;
  return options;
}

}  // namespace drydock::setup
