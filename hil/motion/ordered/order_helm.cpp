#include "hil/motion/ordered/order_helm.hpp"

#include <array>

#include "drivers/measurement/actuator_order.hpp"

namespace drydock::motion {

using measurement::actuator_count;
using measurement::propeller_number;

OrderHelm::OrderHelm(const rig_config::VehicleConfig& vehicle, double speed_mps, Stamp start)
    : advance_m_(vehicle.propeller.advance_m), log_({0, 0, 0, speed_mps / advance_m_}, start) {}

void OrderHelm::give(int actuator, double value, Stamp at) {
  log_.give(static_cast<std::size_t>(actuator), value, at);
}

Command OrderHelm::command(std::int64_t step, const VehicleState&, AutopilotMemory&) const {
  std::array<double, actuator_count> told{};
  log_.read(step, told);
  return {told[0], told[1], told[2], advance_m_ * told[propeller_number]};
}

}  // namespace drydock::motion
