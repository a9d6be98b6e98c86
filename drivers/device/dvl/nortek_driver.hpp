#pragma once

#include "drivers/device/stream_driver.hpp"
#include "drivers/wire/dvl/nortek.hpp"

namespace drydock::device {

/// Nortek DVL: PNORBT6 to 9 -> BottomVelocity; `valid_at` by the sentence's own age, else by the
/// configured latency. Sentences of one beam, or of speed and direction alone, give no velocity of
/// the body. No altitude: the distances do not know how the DVL is tilted.
class NortekDriver final : public StreamDriver<wire::Nortek::max_frame> {
 public:
  explicit NortekDriver(const DriverOptions& options)
      : StreamDriver(options), mounting_(options.mounting) {}

  void receive(wire::Bytes bytes, Stamp received_at, Output& out) override;

 private:
  void publish(const wire::NortekVelocity& sentence, Origin origin, Output& out) const;

  Mounting mounting_;
};

}  // namespace drydock::device
