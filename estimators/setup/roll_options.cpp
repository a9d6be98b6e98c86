#include "estimators/setup/options_of.hpp"

namespace drydock::setup {

pipeline::RollOptions options_of(const rig_config::RollConfig& config,
                                 const EstimatorInRig& place) {
  pipeline::RollOptions roll;
  roll.gnss = index_of(place.rig, config.gnss);
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

}  // namespace drydock::setup
