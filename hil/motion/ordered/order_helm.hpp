#pragma once

#include <array>

#include "drivers/measurement/actuator_order.hpp"
#include "hil/motion/ordered/order_log.hpp"
#include "hil/motion/ordered/takes_orders.hpp"
#include "hil/motion/vehicle/helm.hpp"

namespace drydock::motion {

/// Rudder, planes and propeller under orders. Until its first order a surface is amidships, and the
/// propeller keeps the rate of the speed at which the mission begins.
class OrderHelm final : public Helm, public OrderSink {
 public:
  OrderHelm(const rig_config::VehicleConfig& vehicle, double speed_mps, Stamp start);

  void give(int actuator, double value, Stamp at) override;
  double within_limits(int actuator, double value) const override;
  Command command(std::int64_t step, const VehicleState& state,
                  AutopilotMemory& memory) const override;

 private:
  double advance_m_;
  std::array<double, measurement::actuator_count> most_;
  OrderLog log_;
};

}  // namespace drydock::motion
