#pragma once

#include "drivers/device/bus/bus_driver.hpp"
#include "drivers/device/bus/canopen_node.hpp"
#include "drivers/wire/canopen/cia404_pressure.hpp"

namespace drydock::device {

/// CANopen pressure transmitter. TPDO1 gives the pressure; the configured water column gives the
/// depth. A gauge transmitter measures relative to the pressure at the surface.
class Cia404PressureDriver final : public BusDriver<wire::Cia404Pressure> {
 public:
  explicit Cia404PressureDriver(const DriverOptions& options);

  void receive(const wire::CanFrame& frame, Stamp received_at, Output& out) override;
  void restart(Stamp now, Output& out) override { node_.restart(now, out); }
  void tick(Stamp now, Output& out) override { node_.tick(now, out); }
  std::optional<Stamp> deadline() const override { return node_.deadline(); }

 private:
  void decode(const wire::CanFrame& frame, Stamp received_at, Output& out);
  void on(const wire::cia404_pressure::ProcessValue& value, const Origin& origin, Output& out);

  CanopenNode node_;
  wire::cia404_pressure::Scale scale_;
  double zero_pa_;  ///< absolute pressure at which the transmitter reads 0
  measurement::WaterColumn water_;
};

}  // namespace drydock::device
