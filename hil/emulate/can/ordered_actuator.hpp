#pragma once

#include "drivers/measurement/actuator_order.hpp"
#include "hil/emulate/sampling_device.hpp"
#include "hil/motion/ordered/takes_orders.hpp"

namespace drydock::emulate {

/// One actuator of the vehicle, behind the node that moves it. Nothing moves where no orders steer
/// the vehicle. Under the fault "stuck" it stands where it was, under "delay" it moves later.
class OrderedActuator {
 public:
  /// `number` as in drivers/measurement/actuator_order.hpp.
  OrderedActuator(const DeviceSetup& setup, int number);
  /// A propeller or thruster whose node has lost its power stops; a surface goes to its last order.
  ~OrderedActuator();
  OrderedActuator(const OrderedActuator&) = delete;
  OrderedActuator& operator=(const OrderedActuator&) = delete;

  /// rad, rad/s. Returns whether the actuator can do that.
  bool order(double value, Stamp at);
  double within_limits(double value) const;  ///< the same value where nothing moves
  void rest(Stamp at);  ///< nobody steers any more: amidships, or no rate of rotation
  void stop(Stamp at);  ///< without force: a surface stays where it is, a shaft stops

  bool turns() const { return number_ >= measurement::propeller_number; }

  /// True once in a time without orders that is longer than `patience`.
  bool times_out(Stamp at, std::chrono::nanoseconds patience);

 private:
  void give(double value, Stamp at);

  const Trajectory& trajectory_;
  std::shared_ptr<const Condition> condition_;
  motion::OrderSink* vehicle_;  ///< null: the vehicle takes no orders
  int number_;
  std::optional<Stamp> ordered_at_;  ///< empty: no order counts
};

}  // namespace drydock::emulate
