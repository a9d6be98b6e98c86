#include "estimators/frame/attitude.hpp"
#include "estimators/setup/options_of.hpp"

namespace drydock::setup {
namespace {

std::optional<pipeline::ReckoningDevice> device_of(const rig_config::Rig& rig,
                                                   const std::string& name) {
  const auto* device = find_device(rig, name);
  if (!device) return {};
  const auto& [roll, pitch, yaw] = device->mounting_rad;
  return pipeline::ReckoningDevice{index_of(rig, name).value(),
                                   Eigen::Vector3d{device->lever_arm_m.data()},
                                   frame::ned_to_body({roll, pitch, yaw}).transpose()};
}

}  // namespace

pipeline::ReckoningOptions options_of(const rig_config::ReckoningConfig& config,
                                      const EstimatorInRig& place) {
  pipeline::ReckoningOptions options;
  options.dvl = device_of(place.rig, config.dvl);
  options.log = device_of(place.rig, config.log);
  options.heading = device_of(place.rig, config.heading);
  options.depth = device_of(place.rig, config.depth);
  options.gnss = device_of(place.rig, config.gnss);
  options.sea_level_m = config.sea_level_m;
  if (config.latitude_rad)
    options.start = frame::Position{*config.latitude_rad, *config.longitude_rad,
                                    config.sea_level_m - config.depth_m};
  options.variation_rad = config.variation_rad;
  options.tilt_sigma_rad = config.tilt_sigma_rad;
  options.depth_sigma_m = config.depth_sigma_m;
  options.gap_s = config.gap_s;
  options.errors = {.position_m = config.position_sigma_m,
                    .heading_rad = config.heading_sigma_rad,
                    .scale = config.scale_sigma,
                    .current_mps = config.current_sigma_mps,
                    .velocity_mps = config.velocity_sigma_mps,
                    .water_speed_mps = config.water_speed_sigma_mps,
                    .wander = config.wander_mps_per_root_s};
  return options;
}

}  // namespace drydock::setup
