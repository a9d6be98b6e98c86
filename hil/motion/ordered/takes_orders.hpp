#pragma once

#include "drivers/measurement/actuator_order.hpp"
#include "hil/motion/truth.hpp"

namespace drydock::motion {

/// The actuators of a vehicle, as those who steer it from outside see them.
class OrderSink {
 public:
  virtual ~OrderSink() = default;
  /// The actuators follow the order from `at` on, with their limits, rates and lags. A time that
  /// was asked for already counts as the first one after it. The last order that is given replaces
  /// those that have not begun.
  virtual void give(const measurement::ActuatorOrder& order, Stamp at) = 0;
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
