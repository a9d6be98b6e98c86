#pragma once

#include "hil/motion/ordered/thruster_orders.hpp"
#include "hil/motion/steered/thruster_motion.hpp"
#include "hil/motion/vehicle/steps_on_demand.hpp"

namespace drydock::motion {

/// A vehicle whose thrusters take orders: docs/world/steering.md. The same orders at the same times
/// give the same motion to the last bit. It begins at rest.
class OrderedThrusters final : public Trajectory, public TakesOrders {
 public:
  /// `mission.thruster_vehicle` must be set.
  OrderedThrusters(const rig_config::MissionConfig& mission, Stamp start);

  Truth at(Stamp time) const override;  ///< any order, any thread
  Stamp start() const override { return start_; }
  Stamp end() const override { return start_; }  ///< it has no end of its own
  const ocean::Ocean& ocean() const override { return motion_.ocean(); }
  OrderSink* orders() const override { return &orders_; }

 private:
  ThrusterMotion motion_;
  mutable ThrusterOrders orders_;
  mutable StepsOnDemand<ThrusterState> steps_;
  Stamp start_;
};

}  // namespace drydock::motion
