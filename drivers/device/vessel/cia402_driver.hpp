#pragma once

#include "drivers/device/bus/bus_driver.hpp"
#include "drivers/device/bus/canopen_node.hpp"
#include "drivers/wire/canopen/cia402.hpp"

namespace drydock::device {

/// Feedback of one actuator from its CiA 402 drive. The configured instance says which one: 0 the
/// rudder, 1 the stern planes, 2 the bow planes, 3 the propeller, from 4 on a thruster, whose turns
/// are those of a propeller. Angles have the signs of
/// ActuatorState. It reports a drive that goes into fault; device/order commands one.
class Cia402Driver final : public BusDriver<wire::Cia402> {
 public:
  explicit Cia402Driver(const DriverOptions& options);

  void receive(const wire::CanFrame& frame, Stamp received_at, Output& out) override;
  void restart(Stamp now, Output& out) override { node_.restart(now, out); }
  void tick(Stamp now, Output& out) override { node_.tick(now, out); }
  std::optional<Stamp> deadline() const override { return node_.deadline(); }

 private:
  void decode(const wire::CanFrame& frame, Stamp received_at, Output& out);
  void on(const wire::cia402::DriveStatus& status, const Origin& origin, Output& out);

  CanopenNode node_;
  int actuator_;
  std::optional<wire::cia402::DriveState> state_;  ///< the last that it told
};

}  // namespace drydock::device
