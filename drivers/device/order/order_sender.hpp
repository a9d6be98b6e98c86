#pragma once

#include <optional>

#include "drivers/device/driver.hpp"
#include "drivers/measurement/actuator_order.hpp"

namespace drydock::device {

/// The commanding end of a CAN bus: orders come in, frames for the actuators go out. Sans-I/O as a
/// driver, and apart from it, because who reads a sensor must not be able to move the vehicle.
class OrderSender {
 public:
  virtual ~OrderSender() = default;
  /// The bus was opened (again).
  virtual void restart(Stamp now, Output& out) = 0;
  /// Sends an order. Orders that stop coming take the actuators to their safe state.
  virtual void order(const measurement::ActuatorOrder& order, Stamp now, Output& out) = 0;
  virtual void receive(const wire::CanFrame& frame, Stamp now, Output& out) = 0;
  virtual void tick(Stamp now, Output& out) = 0;      ///< called at or after deadline()
  virtual std::optional<Stamp> deadline() const = 0;  ///< time of the next tick()
};

}  // namespace drydock::device
