#include "hil/motion/ordered/thruster_orders.hpp"

#include <algorithm>

#include "drivers/measurement/actuator_order.hpp"

namespace drydock::motion {

ThrusterOrders::ThrusterOrders(const rig_config::ThrusterVehicleConfig& vehicle, Stamp start)
    : log_(std::vector<double>(vehicle.thrusters.size(), 0.0), start) {
  for (const auto& thruster : vehicle.thrusters) limits_radps_.push_back(thruster.limit_radps);
}

void ThrusterOrders::give(int actuator, double radps, Stamp at) {
  const auto i = static_cast<std::size_t>(actuator - measurement::first_thruster_number);
  log_.give(i, std::clamp(radps / limits_radps_.at(i), -1.0, 1.0), at);
}

double ThrusterOrders::within_limits(int actuator, double radps) const {
  const double most =
      limits_radps_.at(static_cast<std::size_t>(actuator - measurement::first_thruster_number));
  return std::clamp(radps, -most, most);
}

std::span<const double> ThrusterOrders::outputs(std::int64_t step, Outputs& room) const {
  const std::span<double> told(room.data(), limits_radps_.size());
  log_.read(step, told);
  return told;
}

}  // namespace drydock::motion
