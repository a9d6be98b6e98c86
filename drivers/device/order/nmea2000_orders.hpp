#pragma once

#include <array>

#include "drivers/device/order/order_sender.hpp"
#include "drivers/wire/j1939/j1939_address_claim.hpp"

namespace drydock::device {

/// Orders on NMEA 2000: PGN 127245 with an angle order for rudder (instance 0), stern planes (1)
/// and bow planes (2), PGN 127488 with the wanted rate of the shaft. It claims an address, and is
/// silent without one.
class Nmea2000Orders final : public OrderSender {
 public:
  /// `moves` by the numbers of measurement::value_of(): which actuators this sender commands.
  Nmea2000Orders(std::array<bool, measurement::actuator_count> moves, std::uint8_t engine_instance,
                 std::uint8_t preferred_address);

  void restart(Stamp now, Output& out) override;
  void order(const measurement::ActuatorOrder& order, Stamp now, Output& out) override;
  void receive(const wire::CanFrame& frame, Stamp now, Output& out) override;
  void tick(Stamp now, Output& out) override;
  std::optional<Stamp> deadline() const override;

 private:
  std::array<bool, measurement::actuator_count> moves_;
  std::uint8_t engine_instance_;
  wire::j1939::AddressClaim claim_;
};

}  // namespace drydock::device
