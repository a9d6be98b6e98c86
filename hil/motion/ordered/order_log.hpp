#pragma once

#include <array>
#include <mutex>
#include <vector>

#include "hil/motion/ordered/takes_orders.hpp"
#include "hil/motion/vehicle/helm.hpp"

namespace drydock::motion {

/// All orders that the actuators of a vehicle got: a helm. An actuator takes up an order with its
/// next cycle of 10 ms. Until its first order a surface is amidships, and the propeller keeps the
/// rate of the speed at which the mission begins.
class OrderLog final : public Helm, public OrderSink {
 public:
  OrderLog(const rig_config::VehicleConfig& vehicle, double speed_mps, Stamp start);

  void give(const measurement::ActuatorOrder& order, Stamp at) override;
  Command command(std::int64_t step, const VehicleState& state,
                  AutopilotMemory& memory) const override;

 private:
  struct Entry {
    std::int64_t step;
    double value;
  };
  using Series = std::vector<Entry>;

  static double value_at(const Series& series, std::int64_t step);

  double advance_m_;
  Stamp start_;
  mutable std::mutex mutex_;
  std::array<Series, measurement::actuator_count> series_;
  mutable std::int64_t asked_ = 0;  ///< the latest step that was asked for; the first is fixed
};

}  // namespace drydock::motion
