#pragma once

#include "drivers/device/burst.hpp"
#include "drivers/device/bus/nmea2000_driver.hpp"
#include "drivers/device/vessel/attitude_axes.hpp"

namespace drydock::device {

/// Compass on NMEA 2000, one measurement per frame: PGN 127250 heading, 127251 rate of turn, 127257
/// roll and pitch. The yaw of 127257 has no reference and is not read. A magnetic heading without a
/// variation takes that of the last PGN 127258, which any node of the bus may send. Impossible
/// angles and rates are refused. Consecutive frames of one source were all true before the first
/// was sent.
class Nmea2000AttitudeDriver final : public Nmea2000Driver {
 public:
  explicit Nmea2000AttitudeDriver(const DriverOptions& options);

  void receive(const wire::CanFrame& frame, Stamp received_at, Output& out) override;

 private:
  Origin in_burst(const wire::CanFrame& frame, Stamp received_at, std::size_t kind);
  void on(const wire::nmea2000::VesselHeading& heading, const Origin& origin, Output& out);
  void on(const wire::nmea2000::RateOfTurn& turn, const Origin& origin, Output& out);
  void on(const wire::nmea2000::Attitude& attitude, const Origin& origin, Output& out);
  void on(const wire::nmea2000::MagneticVariation& variation, const Origin& origin, Output& out);
  void on(const wire::j1939::AddressClaimed& claim, const Origin& origin, Output& out);

  AttitudeAxes axes_;
  SourceFilter source_, variation_source_{0};
  std::optional<double> variation_rad_;
  Burst burst_;
  std::uint8_t burst_source_ = 0;
};

}  // namespace drydock::device
