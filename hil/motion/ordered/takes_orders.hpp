#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hil/motion/truth.hpp"

namespace drydock::motion {

struct OrderCounters {
  std::uint64_t orders = 0;
  std::uint64_t limited = 0;  ///< beyond what the actuator can do
};

/// How the orders went, as lines for the end of a run; none without orders.
std::vector<std::string> notes_of(const OrderCounters& counters);

/// The actuators of a vehicle, as those who steer it from outside see them.
class OrderSink {
 public:
  virtual ~OrderSink() = default;
  /// The actuator, by its number on the wires (drivers/measurement/actuator_order.hpp), follows the
  /// order (rad, rad/s) from `at` on, with its limits, rate and lag. A time that was asked for
  /// already counts as the first one after it. The last order that is given replaces those that
  /// have not begun.
  virtual void give(int actuator, double value, Stamp at) = 0;
  /// The nearest value that the actuator can have.
  virtual double within_limits(int actuator, double value) const = 0;

  /// Counts an order of a host.
  void count(bool limited) {
    ++counters_.orders;
    counters_.limited += limited ? 1 : 0;
  }
  const OrderCounters& counters() const { return counters_; }

 private:
  OrderCounters counters_;
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
