#pragma once

#include "drivers/device/dvl/dvl_finish.hpp"
#include "drivers/device/dvl/dvl_solution.hpp"
#include "drivers/device/stream_driver.hpp"
#include "drivers/wire/dvl/pd0.hpp"

namespace drydock::device {

/// DVL that speaks PD0: bottom track of each ensemble becomes BottomVelocity in the body frame.
/// dvl_solution.hpp converts from beam, instrument, ship or earth axes to the body. If an ensemble
/// has high-resolution velocity or vertical range, the driver prefers them to those of bottom
/// track. It prefers the age of the bottom echoes to the configured latency. An ensemble without
/// bottom track gives no measurement. An ensemble without bottom lock gives a measurement without
/// velocity.
class DvlDriver final : public StreamDriver<wire::Pd0::max_frame> {
 public:
  explicit DvlDriver(const DriverOptions& options)
      : StreamDriver(options, wire::Pd0::scan), solution_(options), finish_(options) {}

 private:
  void on_frame(wire::Bytes frame, const Arrival& arrival, Output& out) override;
  void on(const wire::Pd0Ensemble& ensemble, const Origin& origin, Output& out);

  DvlSolution solution_;
  DvlFinish finish_;
};

}  // namespace drydock::device
