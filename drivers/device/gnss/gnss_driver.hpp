#pragma once

#include "drivers/device/epoch_begin.hpp"
#include "drivers/device/gnss/epoch_pause.hpp"
#include "drivers/device/gnss/nmea_epoch.hpp"
#include "drivers/device/gnss/position_talker.hpp"
#include "drivers/device/gnss/ublox_setup.hpp"
#include "drivers/device/gnss/ubx_epoch.hpp"
#include "drivers/device/gnss/utc_date.hpp"
#include "drivers/device/stream_driver.hpp"
#include "drivers/wire/ubx/ubx_nmea.hpp"

namespace drydock::device {

/// Satellite receiver that speaks UBX, NMEA 0183, or both on one port. It gives one GnssFix per
/// epoch, and GnssSatellites if the receiver sends them.
///    UBX   NAV-PVT is a complete fix and NAV-SAT a complete sky: published at once. Older
///          receivers send both in parts with one iTOW. That epoch ends with NAV-EOE, when another
///          iTOW begins, or when the line pauses. valid_at follows from the first navigation
///          message of the iTOW, because earlier messages on the line delay the later ones.
///    NMEA  the sentences of an epoch have one time of day. The epoch ends when another time
///          begins or the line pauses. The date is that of the last sentence that told one. Of
///          several receivers on the line one counts (PositionTalker).
/// What comes after its epoch has ended, and what is of another receiver, is refused.
/// Where the rig says how, a u-blox is set up when the link opens, and again after it lost its
/// settings (UbloxSetup).
/// A message is ignored if a better one of its epoch has the same content: parts beside NAV-PVT
/// (NAV-SAT), NMEA beside UBX.
class GnssDriver final : public StreamDriver<wire::UbxNmea::max_frame> {
 public:
  explicit GnssDriver(const DriverOptions& options);

  void receive(wire::Bytes bytes, Stamp received_at, Output& out) override;
  void tick(Stamp now, Output& out) override;
  std::optional<Stamp> deadline() const override;
  void finish(Output& out) override;
  void restart(Stamp now, Output& out) override;

 private:
  void on_frame(wire::Bytes frame, const Arrival& arrival, Output& out) override;
  std::optional<Stamp> epoch_ends_at() const;  ///< by a pause; empty: no epoch has begun
  void on(const wire::NavPvt& pvt, const Origin& origin, Output& out);
  void on(const wire::NavSat& sat, const Origin& origin, Output& out);
  void on(const wire::NavEoe& eoe, const Origin& origin, Output& out);
  template <class Part>
  requires requires(UbxEpoch& epoch, const Part& part, const Origin& o) { epoch.add(part, o); }
  void on(const Part& part, const Origin& origin, Output& out);
  /// False if the sentence is of another receiver than the one that counts.
  bool is_of_receiver(wire::Talker talker, bool tells_position, const Origin& origin, Output& out);
  template <class Sentence>
  void begin_or_go_on(const Sentence& sentence, const Origin& origin, Output& out);
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

  /// Starts the epoch of a UBX message and ends the previous one.
  Origin enter_epoch(std::chrono::milliseconds itow, const Origin& origin, Output& out);
  void close_ubx_epoch(Output& out);
  void close_nmea_epoch(Output& out);

  EpochPause pause_;  ///< a pause this long on the line ends an epoch
  Stamp last_bytes_{};
  std::chrono::nanoseconds damaged_{};  ///< on the line, in front of the message

  UbloxSetup setup_;
  PositionTalker talker_;
  UtcDate date_;
  NmeaEpoch nmea_;
  EpochBegin nmea_begin_;
  std::chrono::nanoseconds nmea_damaged_{};  ///< in front of the open epoch
  NmeaEpoch::TimeOfDay closed_time_of_day_;
  Stamp closed_at_{};

  UbxEpoch ubx_;
  EpochBegin ubx_begin_;
  std::optional<std::chrono::milliseconds> itow_;  ///< iTOW of the current UBX epoch
  Stamp itow_valid_at_{}, itow_received_at_{};     ///< of its first message, of its last one
  std::optional<std::chrono::milliseconds> fix_itow_, satellites_itow_;  ///< last published
  std::optional<std::chrono::milliseconds> closed_itow_;  ///< parts with this iTOW come too late
  std::optional<Stamp> pvt_at_, sat_at_;                  ///< last complete messages
  std::optional<Stamp> ubx_fix_at_, ubx_satellites_at_;   ///< last published from UBX
};

}  // namespace drydock::device
