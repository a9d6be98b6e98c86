#pragma once

#include "drivers/device/bus/bus_driver.hpp"
#include "drivers/device/bus/node_search.hpp"
#include "drivers/device/bus/source_filter.hpp"
#include "drivers/device/imu/j1939_imu_pair.hpp"
#include "drivers/wire/j1939/mv5.hpp"

namespace drydock::device {

/// MicroStrain MV5 on J1939: joins the rate and the acceleration of one instant into one ImuSample.
/// X is the longitudinal axis, Y the lateral one, Z the vertical one, right-handed with Z up; the
/// mounting turns them to the body. It ignores the device's own attitude.
class Mv5ImuDriver final : public BusDriver<wire::Mv5> {
 public:
  explicit Mv5ImuDriver(const DriverOptions& options);

  void receive(const wire::CanFrame& frame, Stamp received_at, Output& out) override;
  void restart(Stamp now, Output& out) override;
  void tick(Stamp now, Output& out) override { search_.tick(now, out); }
  std::optional<Stamp> deadline() const override { return search_.deadline(); }
  void finish(Output& out) override { pair_.finish(out); }

 private:
  void on(const wire::mv5::AngularRate& m, const wire::CanFrame& frame, Stamp at, Output& out);
  void on(const wire::mv5::Acceleration& m, const wire::CanFrame& frame, Stamp at, Output& out);
  void on(const wire::j1939::AddressClaimed& m, const wire::CanFrame& frame, Stamp at, Output& out);
  bool accepts(std::uint8_t source, Stamp at);

  SourceFilter source_;
  NodeSearch search_;
  J1939ImuPair pair_;
};

}  // namespace drydock::device
