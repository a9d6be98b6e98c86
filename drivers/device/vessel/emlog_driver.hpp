#pragma once

#include "drivers/device/burst.hpp"
#include "drivers/device/stream_driver.hpp"
#include "drivers/device/vessel/log_axes.hpp"
#include "drivers/wire/nmea0183/nmea0183.hpp"

namespace drydock::device {

/// EM log that speaks NMEA 0183: VHW, VBW, VLW become WaterSpeed, one measurement per sentence.
/// Only values against the water are published, never the ground values of VBW and VLW. A log that
/// sends VBW and VHW gives the same speed twice, so the driver ignores VHW while VBW comes.
/// Consecutive sentences were all true before the first was sent.
class EmLogDriver final : public StreamDriver<wire::Nmea0183::max_frame> {
 public:
  explicit EmLogDriver(const DriverOptions& options)
      : StreamDriver(options, wire::Nmea0183::scan), axes_(options), burst_(shortest_pause) {}

 private:
  void on_frame(wire::Bytes frame, const Arrival& arrival, Output& out) override;
  /// Logs send once to ten times a second; hosts delay bytes by some milliseconds.
  static constexpr std::chrono::milliseconds shortest_pause{10};

  void on(const wire::Vhw& vhw, const Origin& origin, Output& out);
  void on(const wire::Vbw& vbw, const Origin& origin, Output& out);
  void on(const wire::Vlw& vlw, const Origin& origin, Output& out);

  LogAxes axes_;
  Burst burst_;
  std::optional<Stamp> vbw_at_;
};

}  // namespace drydock::device
