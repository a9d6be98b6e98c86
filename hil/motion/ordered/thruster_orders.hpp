#pragma once

#include <array>
#include <span>
#include <vector>

#include "hil/motion/ordered/order_log.hpp"
#include "hil/motion/ordered/takes_orders.hpp"
#include "hil/motion/truth.hpp"
#include "rig_config/thruster_vehicle.hpp"

namespace drydock::motion {

/// Thrusters under orders for the turns of their shafts. Until its first order a thruster is at
/// rest.
class ThrusterOrders final : public OrderSink {
 public:
  using Outputs = std::array<double, most_thrusters>;

  ThrusterOrders(const rig_config::ThrusterVehicleConfig& vehicle, Stamp start);

  void give(int actuator, double radps, Stamp at) override;
  double within_limits(int actuator, double radps) const override;

  /// Shares of the full command at a step of 10 ms; they are in `room`.
  std::span<const double> outputs(std::int64_t step, Outputs& room) const;

 private:
  std::vector<double> limits_radps_;
  OrderLog log_;
};

}  // namespace drydock::motion
