#include "hil/sensor/mounting.hpp"

#include "estimators/frame/attitude.hpp"

namespace drydock::sensor {

Mounting mounting_of(const rig_config::DeviceConfig& config) {
  const auto& [roll, pitch, yaw] = config.mounting_rad;
  const auto& arm = config.lever_arm_m;
  return {frame::ned_to_body({roll, pitch, yaw}).transpose(), {arm[0], arm[1], arm[2]}};
}

}  // namespace drydock::sensor
