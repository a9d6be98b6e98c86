#pragma once

#include "drivers/device/dvl/dvl_solution.hpp"
#include "drivers/device/stream_driver.hpp"
#include "drivers/wire/dvl/pd0.hpp"

namespace drydock::device {

/// DVL speaking PD0: bottom track of each ensemble -> BottomVelocity in the body frame. The way
/// from beam, instrument, ship or earth axes to the body is dvl_solution.hpp. High-resolution
/// velocity and vertical range count before bottom track's where an ensemble has them, and the age
/// of the bottom echoes before the configured latency. An ensemble without bottom track gives no
/// measurement, one without bottom lock a measurement without velocity.
class DvlDriver final : public StreamDriver<wire::Pd0::max_frame> {
 public:
  explicit DvlDriver(const DriverOptions& options) : StreamDriver(options), solution_(options) {}

  void receive(wire::Bytes bytes, Stamp received_at, Output& out) override;

 private:
  void on(const wire::Pd0Ensemble& ensemble, const Origin& origin, Output& out);

  DvlSolution solution_;
};

}  // namespace drydock::device
