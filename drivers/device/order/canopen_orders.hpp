#pragma once

#include <vector>

#include "drivers/device/order/drive_channel.hpp"

namespace drydock::device {

/// Orders to the CiA 402 drives of one CANopen bus. It sends the heartbeat that they watch as long
/// as orders come, so drives stop if whoever steers falls silent. The drivers of the drives start
/// their nodes.
class CanopenOrders final : public OrderSender {
 public:
  static constexpr std::uint8_t master = 127;  ///< its node number

  struct Drive {
    std::uint8_t node = 1;
    int actuator = 0;                          ///< number of measurement::value_of()
    std::chrono::milliseconds patience{1000};  ///< silence that stops it; up to 65 s
  };
  explicit CanopenOrders(const std::vector<Drive>& drives);

  void restart(Stamp now, Output& out) override;
  void order(const measurement::ActuatorOrder& order, Stamp now, Output& out) override;
  void receive(const wire::CanFrame& frame, Stamp now, Output& out) override;
  void tick(Stamp, Output&) override {}
  std::optional<Stamp> deadline() const override { return {}; }

 private:
  std::vector<DriveChannel> drives_;
  std::chrono::nanoseconds beat_period_;
  std::optional<Stamp> beaten_at_;
};

}  // namespace drydock::device
