#pragma once

#include "hil/motion/truth.hpp"

namespace drydock::motion {

/// The actuators of a vehicle, as those who steer it from outside see them.
class OrderSink {
 public:
  virtual ~OrderSink() = default;
  /// The actuator, by its number on the wires (drivers/measurement/actuator_order.hpp), follows the
  /// order (rad, rad/s) from `at` on, with its limits, rate and lag. A time that was asked for
  /// already counts as the first one after it. The last order that is given replaces those that
  /// have not begun.
  virtual void give(int actuator, double value, Stamp at) = 0;
};

/// A motion that may have actuators under orders, or passes on one that has.
class TakesOrders {
 public:
  virtual ~TakesOrders() = default;
  virtual OrderSink* orders() const = 0;  ///< null: nobody steers it over the wires
};

/// Null: nobody steers this motion over the wires.
inline OrderSink* orders_of(const Trajectory& motion) {
  const auto* taker = dynamic_cast<const TakesOrders*>(&motion);
  return taker != nullptr ? taker->orders() : nullptr;
}

}  // namespace drydock::motion
