#include "hil/motion/ordered/order_helm.hpp"

#include <algorithm>

namespace drydock::motion {

using measurement::actuator_count;
using measurement::propeller_number;

OrderHelm::OrderHelm(const rig_config::VehicleConfig& vehicle, double speed_mps, Stamp start)
    : advance_m_(vehicle.propeller.advance_m),
      most_{vehicle.rudder.limit_rad, vehicle.stern_planes.limit_rad, vehicle.bow_planes.limit_rad,
            vehicle.propeller.limit_radps},
      log_({0, 0, 0, speed_mps / advance_m_}, start) {}

double OrderHelm::within_limits(int actuator, double value) const {
  const double most = most_.at(static_cast<std::size_t>(actuator));
  return std::clamp(value, actuator == propeller_number ? 0 : -most, most);
}

void OrderHelm::give(int actuator, double value, Stamp at) {
  log_.give(static_cast<std::size_t>(actuator), value, at);
}

Command OrderHelm::command(std::int64_t step, const VehicleState&, AutopilotMemory&) const {
  std::array<double, actuator_count> told{};
  log_.read(step, told);
  return {told[0], told[1], told[2], advance_m_ * told[propeller_number]};
}

}  // namespace drydock::motion
