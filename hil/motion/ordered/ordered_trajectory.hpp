#pragma once

#include "hil/motion/ordered/order_helm.hpp"
#include "hil/motion/vehicle/voyage.hpp"

namespace drydock::motion {

/// A vehicle that sails by the Gertler-Hagen equations, and whose rudder, planes and propeller take
/// orders: docs/world/steering.md. The same orders at the same times give the same motion to the
/// last bit. It cannot leave the water, nor sink into the bed; where the
/// equations hold no more, it stops.
class OrderedTrajectory final : public Trajectory, public TakesOrders {
 public:
  /// `mission.vehicle` must be set. Throws std::invalid_argument for a vehicle that is not
  /// possible, BadMission for legs or waypoints that it cannot sail.
  OrderedTrajectory(const rig_config::MissionConfig& mission, Stamp start);

  Truth at(Stamp time) const override;  ///< any order, any thread
  Stamp start() const override { return start_; }
  Stamp end() const override;  ///< when the plan has been sailed once; without one start()
  const ocean::Ocean& ocean() const override { return voyage_.motion().ocean(); }
  OrderSink* orders() const override { return &orders_; }

 private:
  mutable OrderHelm orders_;
  Voyage voyage_;
  Stamp start_;
  double planned_s_;
};

}  // namespace drydock::motion
