#pragma once

#include "drivers/device/gnss/nmea_epoch.hpp"
#include "drivers/device/gnss/ubx_epoch.hpp"
#include "drivers/device/stream_driver.hpp"
#include "drivers/wire/ubx/ubx_nmea.hpp"

namespace drydock::device {

/// Satellite receiver speaking UBX, NMEA 0183, or both on one port: one GnssFix per epoch, and
/// GnssSatellites where the receiver sends them.
///   UBX   NAV-PVT is a whole fix and NAV-SAT a whole sky: published at once. Older receivers say
///         both in parts of one iTOW; that epoch ends with NAV-EOE, when another iTOW begins or
///         when the line pauses. valid_at counts from the first navigation message of its iTOW, as
///         the ones before it on the line delayed it.
///   NMEA  sentences of one time of day; the epoch ends when another time begins or the line
///         pauses.
/// What says the same as another message of its epoch is left out: parts beside NAV-PVT (NAV-SAT),
/// NMEA beside UBX.
class GnssDriver final : public StreamDriver<wire::UbxNmea::max_frame> {
 public:
  explicit GnssDriver(const DriverOptions& options);

  void receive(wire::Bytes bytes, Stamp received_at, Output& out) override;
  void tick(Stamp now, Output& out) override;
  std::optional<Stamp> deadline() const override;
  void restart(Stamp now, Output& out) override;

 private:
  void on(const wire::NavPvt& pvt, const Origin& origin, Output& out);
  void on(const wire::NavSat& sat, const Origin& origin, Output& out);
  void on(const wire::NavEoe& eoe, const Origin& origin, Output& out);
  template <class Part>
  requires requires(UbxEpoch& epoch, const Part& part, const Origin& o) { epoch.add(part, o); }
  void on(const Part& part, const Origin& origin, Output& out);
  template <class Sentence>
  void on_timed(const Sentence& sentence, const Origin& origin, Output& out);
  void on(const wire::Gga& s, const Origin& o, Output& out) { on_timed(s, o, out); }
  void on(const wire::Rmc& s, const Origin& o, Output& out) { on_timed(s, o, out); }
  void on(const wire::Gns& s, const Origin& o, Output& out) { on_timed(s, o, out); }
  void on(const wire::Gll& s, const Origin& o, Output& out) { on_timed(s, o, out); }
  void on(const wire::Gst& s, const Origin& o, Output& out) { on_timed(s, o, out); }
  void on(const wire::Zda& s, const Origin& o, Output& out) { on_timed(s, o, out); }
  template <class Sentence>
  void on_untimed(const Sentence& sentence, const Origin& origin, Output& out);
  void on(const wire::Vtg& s, const Origin& o, Output& out) { on_untimed(s, o, out); }
  void on(const wire::Gsa& s, const Origin& o, Output& out) { on_untimed(s, o, out); }
  void on(const wire::Gsv& s, const Origin& o, Output& out) { on_untimed(s, o, out); }

  /// Enters the epoch of a UBX message, ending the one before.
  Origin enter_epoch(std::chrono::milliseconds itow, const Origin& origin, Output& out);
  void close_ubx_epoch(Output& out);
  void close_nmea_epoch(Output& out);

  wire::Scan (*scan_)(wire::Bytes);
  std::chrono::nanoseconds pause_;  ///< of the line that ends an epoch
  Stamp last_bytes_{};

  NmeaEpoch nmea_;
  NmeaEpoch::TimeOfDay closed_time_of_day_;
  Stamp closed_at_{};

  UbxEpoch ubx_;
  std::optional<std::chrono::milliseconds> itow_;  ///< of the UBX epoch
  Stamp itow_valid_at_{};
  std::optional<std::chrono::milliseconds> fix_itow_, satellites_itow_;  ///< last told
  std::optional<std::chrono::milliseconds> closed_itow_;  ///< whose parts are no longer waited for
  std::optional<Stamp> pvt_at_, sat_at_;                  ///< last whole messages
  std::optional<Stamp> ubx_fix_at_, ubx_satellites_at_;   ///< last told by UBX, whole or in parts
};

}  // namespace drydock::device
