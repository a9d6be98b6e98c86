#pragma once

#include "drivers/device/dvl/dvl_finish.hpp"
#include "drivers/device/dvl/dvl_solution.hpp"
#include "drivers/device/dvl/pd6_epoch.hpp"
#include "drivers/device/stream_driver.hpp"

namespace drydock::device {

/// DVL that speaks PD6: each complete ensemble becomes one BottomVelocity. The driver uses :BI,
/// otherwise :BE rotated back with the attitude of :SA. It does not use :BS, which does not say
/// whether it is levelled. The range of :BD is the altitude if there is a velocity. An ensemble
/// with a lost or damaged line gives no measurement and is reported.
class Pd6Driver final : public StreamDriver<wire::Pd6::max_frame> {
 public:
  explicit Pd6Driver(const DriverOptions& options)
      : StreamDriver(options, wire::Pd6::scan), solution_(options), finish_(options) {}

  void restart(Stamp now, Output& out) override;

 private:
  void on_frame(wire::Bytes frame, const Arrival& arrival, Output& out) override;
  void publish(Output& out);

  DvlSolution solution_;
  DvlFinish finish_;
  Pd6Epoch epoch_;
};

}  // namespace drydock::device
