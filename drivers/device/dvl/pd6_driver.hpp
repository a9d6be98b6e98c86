#pragma once

#include "drivers/device/dvl/dvl_solution.hpp"
#include "drivers/device/dvl/pd6_epoch.hpp"
#include "drivers/device/stream_driver.hpp"

namespace drydock::device {

/// DVL speaking PD6: each whole ensemble -> one BottomVelocity. :BI counts, else :BE turned back
/// with the attitude of :SA; :BS does not say whether it is levelled. The range of :BD is the
/// altitude while there is a velocity. An ensemble with a lost or damaged line is left out and
/// reported.
class Pd6Driver final : public StreamDriver<wire::Pd6::max_frame> {
 public:
  explicit Pd6Driver(const DriverOptions& options) : StreamDriver(options), solution_(options) {}

  void receive(wire::Bytes bytes, Stamp received_at, Output& out) override;
  void restart(Stamp now, Output& out) override;

 private:
  void publish(Output& out);

  DvlSolution solution_;
  Pd6Epoch epoch_;
};

}  // namespace drydock::device
