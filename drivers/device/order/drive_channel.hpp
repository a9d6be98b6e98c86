#pragma once

#include "drivers/device/order/order_sender.hpp"
#include "drivers/wire/canopen/canopen_sdo.hpp"
#include "drivers/wire/canopen/cia402.hpp"

namespace drydock::device {

/// The master's side of one CiA 402 drive. It sets the mode and the heartbeat that the drive
/// watches, leads the drive to "operation enabled", out of a fault too, and sends it targets.
class DriveChannel {
 public:
  struct Options {
    std::uint8_t node = 1;
    int actuator = 0;                  ///< number of measurement::value_of()
    std::uint8_t master = 0;           ///< node whose heartbeat the drive watches
    std::uint16_t patience_ms = 1000;  ///< silence of the master that stops the drive
  };
  explicit DriveChannel(const Options& options) : options_(options) {}

  void restart();
  void order(const measurement::ActuatorOrder& order, Stamp now, Output& out);
  void receive(const wire::CanFrame& frame, Output& out);

  bool enabled() const { return state_ == wire::cia402::DriveState::operation_enabled; }

 private:
  wire::canopen::SdoWrite setting() const;
  void set_up(Stamp now, Output& out);
  std::uint16_t next_word() const;
  void on(const wire::canopen::SdoResponse& response, Output& out);

  Options options_;
  int settings_done_ = 0;                          ///< of two
  std::optional<Stamp> asked_at_;                  ///< a setting whose answer is not there yet
  std::optional<wire::cia402::DriveState> state_;  ///< empty: not heard yet
  std::uint16_t word_ = 0;                         ///< the last that it sent
};

}  // namespace drydock::device
