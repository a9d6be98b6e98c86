#pragma once

#include "drivers/device/burst.hpp"
#include "drivers/device/stream_driver.hpp"
#include "drivers/wire/nmea0183/nmea0183.hpp"

namespace drydock::device {

/// EM log speaking NMEA 0183: VHW, VBW, VLW -> WaterSpeed, one measurement per sentence. Only what
/// is measured against the water comes out; VBW's and VLW's ground values never do. A log that
/// sends VBW and VHW says the same speed twice, so VHW is left out while VBW comes. Sentences in a
/// row were true together, before the first left.
class EmLogDriver final : public StreamDriver<wire::Nmea0183::max_frame> {
 public:
  explicit EmLogDriver(const DriverOptions& options)
      : StreamDriver(options), mounting_(options.mounting), burst_(shortest_pause) {}

  void receive(wire::Bytes bytes, Stamp received_at, Output& out) override;

 private:
  /// Logs send once to ten times a second; hosts hold bytes back for some milliseconds.
  static constexpr std::chrono::milliseconds shortest_pause{10};

  void on(const wire::Vhw& vhw, const Origin& origin, Output& out);
  void on(const wire::Vbw& vbw, const Origin& origin, Output& out);
  void on(const wire::Vlw& vlw, const Origin& origin, Output& out);
  void publish_speed(const std::optional<double>& longitudinal_mps,
                     const std::optional<double>& transverse_mps, const Origin& origin,
                     Output& out) const;

  Mounting mounting_;
  Burst burst_;
  std::optional<Stamp> vbw_at_;
};

}  // namespace drydock::device
