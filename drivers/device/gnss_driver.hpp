#pragma once

#include "drivers/device/nmea_epoch.hpp"
#include "drivers/device/stream_driver.hpp"
#include "drivers/wire/ubx_nmea.hpp"

namespace drydock::device {

/// Satellite receiver speaking UBX, NMEA 0183, or both on one port: one GnssFix per epoch, and
/// GnssSatellites where the receiver sends them.
///   UBX   NAV-PVT is a whole fix and is published at once. valid_at counts from the first
///   navigation
///         message of its iTOW, as the ones before it on the line delayed it.
///   NMEA  sentences of one time of day; the epoch ends when another time begins or the line
///   pauses.
/// While NAV-PVT (NAV-SAT) comes, the NMEA form of the same is left out: it says nothing new.
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
  void on(const wire::NavEoe& eoe, const Origin& origin, Output&) {
    epoch_origin(eoe.itow, origin);
  }
  template <class Sentence>
  void on_timed(const Sentence& sentence, const Origin& origin, Output& out);
  void on(const wire::Gga& s, const Origin& o, Output& out) { on_timed(s, o, out); }
  void on(const wire::Rmc& s, const Origin& o, Output& out) { on_timed(s, o, out); }
  void on(const wire::Gns& s, const Origin& o, Output& out) { on_timed(s, o, out); }
  void on(const wire::Gll& s, const Origin& o, Output& out) { on_timed(s, o, out); }
  void on(const wire::Gst& s, const Origin& o, Output& out) { on_timed(s, o, out); }
  void on(const wire::Zda& s, const Origin& o, Output& out) { on_timed(s, o, out); }
  void on(const wire::Vtg& s, const Origin& o, Output&) { nmea_.add(s, o); }
  void on(const wire::Gsa& s, const Origin& o, Output&) { nmea_.add(s, o); }
  void on(const wire::Gsv& s, const Origin& o, Output&) { nmea_.add(s, o); }

  Origin epoch_origin(std::chrono::milliseconds itow, const Origin& origin);
  void close_nmea_epoch(Output& out);

  wire::Scan (*scan_)(wire::Bytes);
  std::chrono::nanoseconds pause_;  ///< of the line that ends an NMEA epoch
  NmeaEpoch nmea_;
  Stamp last_bytes_{};
  NmeaEpoch::TimeOfDay closed_time_of_day_;
  Stamp closed_at_{};

  std::optional<std::chrono::milliseconds> itow_;  ///< of the UBX epoch
  Stamp itow_valid_at_{};
  std::optional<std::chrono::milliseconds> published_itow_;
  std::optional<Stamp> pvt_at_, sat_at_;
};

}  // namespace drydock::device
