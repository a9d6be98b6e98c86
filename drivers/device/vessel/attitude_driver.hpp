#pragma once

#include <array>

#include "drivers/device/burst.hpp"
#include "drivers/device/stream_driver.hpp"
#include "drivers/device/vessel/attitude_axes.hpp"
#include "drivers/wire/nmea0183/nmea0183.hpp"

namespace drydock::device {

/// Compass that speaks NMEA 0183: THS and HDT give the true heading, HDG and HDM the magnetic one.
/// A compass that sends several gives one heading several times, so the driver ignores a sentence
/// while one that stands before it in this list comes. A heading of THS that is typed in (M) or
/// simulated (S) is refused. Consecutive sentences were all true before the first was sent.
class AttitudeDriver final : public StreamDriver<wire::Nmea0183::max_frame> {
 public:
  explicit AttitudeDriver(const DriverOptions& options)
      : StreamDriver(options, wire::Nmea0183::scan), axes_(options), burst_(shortest_pause) {}

 private:
  void on_frame(wire::Bytes frame, const Arrival& arrival, Output& out) override;
  /// Compasses send up to fifty times a second; hosts delay bytes by some milliseconds.
  static constexpr std::chrono::milliseconds shortest_pause{10};

  enum class Rank : std::uint8_t { ths, hdt, hdg, hdm };

  void on(const wire::Ths& ths, const Origin& origin, Output& out);
  void on(const wire::Hdt& hdt, const Origin& origin, Output& out);
  void on(const wire::Hdg& hdg, const Origin& origin, Output& out);
  void on(const wire::Hdm& hdm, const Origin& origin, Output& out);
  bool counts(Rank rank, bool has_heading, Stamp at);
  void publish(const std::optional<double>& heading_rad, measurement::AttitudeSample result,
               Output& out);

  AttitudeAxes axes_;
  Burst burst_;
  std::array<std::optional<Stamp>, 4> heard_at_;  ///< of each rank, the last with a heading
};

}  // namespace drydock::device
