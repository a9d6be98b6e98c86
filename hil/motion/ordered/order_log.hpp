#pragma once

#include <mutex>
#include <span>
#include <vector>

#include "drivers/measurement/stamp.hpp"

namespace drydock::motion {

using measurement::Stamp;

/// All orders that the actuators of a vehicle got. An actuator takes up an order with its next
/// cycle of 10 ms.
class OrderLog {
 public:
  /// `first`: what each actuator does until its first order.
  OrderLog(const std::vector<double>& first, Stamp start);

  /// As OrderSink::give().
  void give(std::size_t actuator, double value, Stamp at);

  /// What the actuators were told at a step of 10 ms. From then on no order changes that.
  void read(std::int64_t step, std::span<double> values) const;

 private:
  struct Entry {
    std::int64_t step;
    double value;
  };
  using Series = std::vector<Entry>;

  static double value_at(const Series& series, std::int64_t step);

  Stamp start_;
  mutable std::mutex mutex_;
  std::vector<Series> series_;
  mutable std::int64_t asked_ = 0;  ///< the latest step that was asked for; the first is fixed
};

}  // namespace drydock::motion
