#pragma once

#include <optional>

#include "drivers/device/dvl/dvl_finish.hpp"
#include "drivers/device/dvl/dvl_solution.hpp"
#include "drivers/device/stream_driver.hpp"
#include "drivers/wire/dvl/wayfinder.hpp"

namespace drydock::device {

/// Teledyne Wayfinder: the data of each ping become BottomVelocity in the body frame. No public
/// document tells the sign of the velocity: it is that of the rig's `velocity_of`, else the
/// vehicle's, which the driver says once. Without attitude, velocities in earth axes give none, and
/// the ranges no altitude.
class WayfinderDriver final : public StreamDriver<wire::Wayfinder::max_frame> {
 public:
  explicit WayfinderDriver(const DriverOptions& options)
      : StreamDriver(options, wire::Wayfinder::scan),
        of_bed_(options.dvl.velocity_of_bed),
        solution_(options),
        finish_(options) {}

 private:
  void on_frame(wire::Bytes frame, const Arrival& arrival, Output& out) override;
  std::optional<Eigen::Vector3d> velocity_of(const wire::WayfinderPing& ping, Output& out);
  void say_sign(Output& out);

  std::optional<bool> of_bed_;
  bool sign_said_ = false;
  DvlSolution solution_;
  DvlFinish finish_;
};

}  // namespace drydock::device
