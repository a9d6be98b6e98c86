#pragma once

#include "drivers/device/burst.hpp"
#include "drivers/device/bus/nmea2000_driver.hpp"
#include "drivers/device/vessel/log_axes.hpp"

namespace drydock::device {

/// Speed log on NMEA 2000. PGN 128259 gives the speed along the log, PGN 128275 the distance, as
/// separate measurements. The speed on the wire has no sign: direction 1 makes it negative, any
/// other keeps it. A speed over 50 m/s is refused. Only values against the water are published,
/// never the speed over ground. Consecutive frames of one log were all true before the first was
/// sent.
class Nmea2000LogDriver final : public Nmea2000Driver {
 public:
  explicit Nmea2000LogDriver(const DriverOptions& options);

  void receive(const wire::CanFrame& frame, Stamp received_at, Output& out) override;

 private:
  Origin in_burst(const wire::CanFrame& frame, Stamp received_at);
  void on(const wire::nmea2000::Speed& speed, const Origin& origin, Output& out);
  void on(const wire::nmea2000::DistanceLog& log, const Origin& origin, Output& out);
  void on(const wire::j1939::AddressClaimed& claim, const Origin& origin, Output& out);

  LogAxes axes_;
  SourceFilter source_;
  Burst burst_;
  std::uint8_t burst_source_ = 0;
};

}  // namespace drydock::device
