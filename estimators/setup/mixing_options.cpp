#include <array>

#include "estimators/setup/options_of.hpp"
#include "estimators/setup/sensor_grade.hpp"

namespace drydock::setup {

pipeline::MixingOptions options_of(const rig_config::MixingConfig& config,
                                   const EstimatorInRig& place) {
  using enum mixing::MixingType;
  constexpr std::array types{compensated, fixed_gain, fuzzy_inference, gain_schedule};
  pipeline::MixingOptions options;
  options.log = index_of(place.rig, config.log);
  options.ground = witness_of(place);
  options.imu = imu_grade(place);
  options.filter.type = types.at(static_cast<std::size_t>(config.type));
  options.filter.latitude_rad = config.start.latitude_rad;
  options.filter.heading_rad = config.start.heading_rad;
  options.filter.accelerometer_start = config.start.accelerometer;
  options.filter.initial_roll_rad = config.start.initial_roll_rad;
  options.filter.initial_pitch_rad = config.start.initial_pitch_rad;
  options.filter.pivot_m = config.pivot_m;
  return options;
}

}  // namespace drydock::setup
