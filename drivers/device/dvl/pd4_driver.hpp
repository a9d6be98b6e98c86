#pragma once

#include "drivers/device/dvl/dvl_finish.hpp"
#include "drivers/device/dvl/dvl_solution.hpp"
#include "drivers/device/stream_driver.hpp"
#include "drivers/wire/dvl/pd4.hpp"

namespace drydock::device {

/// DVL that speaks PD4 or PD5: each report becomes BottomVelocity in the body frame. PD4 has no
/// attitude. Thus earth and levelled ship velocities give no body velocity, and the ranges give no
/// altitude.
template <class Protocol>
class Pd4Driver final : public StreamDriver<Protocol::max_frame> {
 public:
  explicit Pd4Driver(const DriverOptions& options)
      : StreamDriver<Protocol::max_frame>(options, Protocol::scan),
        solution_(options),
        finish_(options) {}

 private:
  void on_frame(wire::Bytes frame, const Arrival& arrival, Output& out) override;
  void publish(const typename Protocol::Report& report, const Origin& origin, Output& out);

  DvlSolution solution_;
  DvlFinish finish_;
};

extern template class Pd4Driver<wire::Pd4>;
extern template class Pd4Driver<wire::Pd5>;

}  // namespace drydock::device
