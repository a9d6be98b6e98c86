#pragma once

#include "drivers/device/dvl/dvl_finish.hpp"
#include "drivers/device/dvl/echo_times.hpp"
#include "drivers/device/stream_driver.hpp"
#include "drivers/wire/dvl/nortek.hpp"

namespace drydock::device {

/// Nortek DVL: PNORBT6 to 9 become BottomVelocity. `valid_at` follows from the age in the sentence,
/// otherwise from the configured latency. Sentences of one beam, or with only speed and direction,
/// give no velocity of the body. There is no altitude: the distances are not corrected for the tilt
/// of the DVL.
class NortekDriver final : public StreamDriver<wire::Nortek::max_frame> {
 public:
  explicit NortekDriver(const DriverOptions& options)
      : StreamDriver(options, wire::Nortek::scan), mounting_(options.mounting), finish_(options) {}

 private:
  void on_frame(wire::Bytes frame, const Arrival& arrival, Output& out) override;
  void publish(const wire::NortekVelocity& sentence, Origin origin, Output& out);

  Mounting mounting_;
  DvlFinish finish_;
  EchoTimes echo_;
};

}  // namespace drydock::device
