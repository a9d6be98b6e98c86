#pragma once

#include "drivers/device/bus_driver.hpp"
#include "drivers/device/source_filter.hpp"
#include "drivers/wire/cia404_imu.hpp"

namespace drydock::device {

/// CANopen IMU with REAL32 process values: each complete set -> one ImuSample. A node says nothing
/// until it is started, so the driver starts it when the bus opens and whenever it boots up.
/// Emergency messages are reported as trouble.
class Cia404ImuDriver final : public BusDriver<wire::Cia404Imu> {
 public:
  explicit Cia404ImuDriver(const DriverOptions& options);

  void receive(const wire::CanFrame& frame, Stamp received_at, Output& out) override;
  void restart(Stamp now, Output& out) override;

 private:
  void on(const wire::cia404_imu::ImuSet& set, const Origin& end, Output& out);
  void on(const wire::canopen::Heartbeat& heartbeat, Output& out);
  void on(const wire::canopen::Emergency& emergency, Output& out) const;
  bool ours(std::uint8_t node) const { return source_.source().value_or(node) == node; }

  Mounting mounting_;
  SourceFilter source_;
  std::array<Origin, 128> first_frame_{};  ///< of each node's set under way
};

}  // namespace drydock::device
