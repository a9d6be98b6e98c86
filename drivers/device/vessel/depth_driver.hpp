#pragma once

#include "drivers/device/bus/nmea2000_driver.hpp"
#include "drivers/device/vessel/instance_filter.hpp"

namespace drydock::device {

/// Depth on NMEA 2000. PGN 130314 with source "water" gives the pressure; the configured water
/// column gives the depth. The sample also has the last sea temperature of PGN 130312. PGN 128267,
/// an echo sounder's depth below its transducer, gives the altitude as a separate measurement. The
/// altitude was true at the same time as the pressure with the same source and SID. Of several
/// pressures of one sender it takes the configured instance, or else the first heard.
class DepthDriver final : public Nmea2000Driver {
 public:
  explicit DepthDriver(const DriverOptions& options);

  void receive(const wire::CanFrame& frame, Stamp received_at, Output& out) override;

 private:
  void on(const wire::nmea2000::Pressure& pressure, const Origin& origin, Output& out);
  void on(const wire::nmea2000::Temperature& temperature, const Origin& origin, Output& out);
  void on(const wire::nmea2000::WaterDepth& depth, const Origin& origin, Output& out);
  void on(const wire::j1939::AddressClaimed& claim, const Origin& origin, Output& out);

  measurement::WaterColumn water_;
  SourceFilter pressure_source_, temperature_source_, sounder_source_;
  InstanceFilter pressure_instance_, temperature_instance_;
  std::optional<double> temperature_k_;
  Stamp temperature_at_{};

  struct Tie {
    std::uint8_t source = 0;
    std::optional<std::uint8_t> sequence;
    Origin origin;
  };
  Tie last_pressure_;
};

}  // namespace drydock::device
