#include "drivers/device/gnss/gnss_driver.hpp"

#include "drivers/device/gnss/gnss_gate.hpp"
#include "drivers/measurement/earlier.hpp"

namespace drydock::device {

using measurement::GnssFix;
using std::chrono::milliseconds;

namespace {

/// USB adapters and schedulers delay bytes by some tens of milliseconds, and readers pass bytes on
/// in blocks. Neither delay is the end of an epoch.
constexpr milliseconds pause_between_epochs{50};
constexpr milliseconds pause_without_baud{100};
constexpr std::size_t block_bytes = 128;

constexpr milliseconds late_within{500};       ///< it came late, after its epoch
constexpr std::chrono::seconds counts_for{5};  ///< a better message replaces others

bool recent(const std::optional<Stamp>& last, Stamp now) {
  return last && now - *last < counts_for;
}

}  // namespace

GnssDriver::GnssDriver(const DriverOptions& options)
    : StreamDriver(options, options.protocol == wire::Nmea0183::name ? wire::Nmea0183::scan
                                                                     : wire::UbxNmea::scan),
      pause_(options.baud ? pause_between_epochs + timing_.line_time(block_bytes)
                          : pause_without_baud),
      setup_(options.ublox) {}

void GnssDriver::receive(wire::Bytes bytes, Stamp received_at, Output& out) {
  tick(received_at, out);  // a pause before these bytes has ended the epoch, even without a tick
  last_bytes_ = received_at;
  StreamDriver::receive(bytes, received_at, out);
}

void GnssDriver::on_frame(wire::Bytes frame, const Arrival& arrival, Output& out) {
  if (frame[0] == wire::ubx::sync_1) setup_.receive(frame, arrival.read_at, out);
  const auto message = wire::UbxNmea::decode(frame);
  if (!message) return;
  const Origin origin = timing_.of_bytes(arrival);
  std::visit(
      [&](const auto& m) {
        if constexpr (requires { on(m, origin, out); }) on(m, origin, out);
      },
      *message);
}

std::optional<Stamp> GnssDriver::epoch_ends_at() const {
  if (nmea_.empty() && ubx_.empty()) return {};
  return last_bytes_ + pause_;
}

std::optional<Stamp> GnssDriver::deadline() const {
  return measurement::earlier(measurement::earlier(StreamDriver::deadline(), epoch_ends_at()),
                              setup_.deadline());
}

void GnssDriver::tick(Stamp now, Output& out) {
  StreamDriver::tick(now, out);
  setup_.tick(now, out);
  const auto due = epoch_ends_at();
  if (!due || now < *due) return;
  look_behind(out);  // frames of this epoch may wait behind a damaged length
  close_ubx_epoch(out);
  close_nmea_epoch(out);
}

void GnssDriver::finish(Output& out) {
  StreamDriver::finish(out);
  close_ubx_epoch(out);
  close_nmea_epoch(out);
}

void GnssDriver::restart(Stamp now, Output& out) {
  StreamDriver::restart(now, out);
  nmea_.clear();
  ubx_.clear();
  closed_time_of_day_.reset();
  itow_ = fix_itow_ = satellites_itow_ = closed_itow_ = std::nullopt;
  pvt_at_ = sat_at_ = ubx_fix_at_ = ubx_satellites_at_ = std::nullopt;
  // A recording contains the answers at their own times, so it plays as it was recorded.
  setup_.expect_no_answers(timing_.provenance() == measurement::Provenance::replayed);
  setup_.start(now, out);
}

template <class Sentence>
void GnssDriver::on_timed(const Sentence& sentence, const Origin& origin, Output& out) {
  if (nmea_.ends_before(sentence)) close_nmea_epoch(out);
  const bool straggler = !nmea_.time_of_day() && sentence.time_of_day &&
                         sentence.time_of_day == closed_time_of_day_ &&
                         origin.received_at - closed_at_ < late_within;
  if (!straggler) nmea_.add(sentence, origin);
}

template <class Sentence>
void GnssDriver::on_untimed(const Sentence& sentence, const Origin& origin, Output& out) {
  if (nmea_.ends_before(sentence)) close_nmea_epoch(out);
  nmea_.add(sentence, origin);
}

void GnssDriver::close_nmea_epoch(Output& out) {
  if (nmea_.empty()) return;
  const bool fix_told = recent(ubx_fix_at_, last_bytes_) || ubx_.fix();
  const bool satellites_told = recent(ubx_satellites_at_, last_bytes_) || ubx_.satellites();
  const auto fix = fix_told ? std::nullopt : nmea_.fix();
  const auto satellites = satellites_told ? std::nullopt : nmea_.satellites();
  if (nmea_.time_of_day()) closed_time_of_day_ = nmea_.time_of_day();
  closed_at_ = last_bytes_;
  nmea_.clear();
  if (fix) publish_possible(*fix, out);
  if (satellites) out.publish(*satellites);
}

Origin GnssDriver::enter_epoch(milliseconds itow, const Origin& origin, Output& out) {
  if (itow_ != itow) {
    close_ubx_epoch(out);
    itow_ = itow;
    itow_valid_at_ = origin.valid_at;
  }
  Origin of_epoch = origin;
  of_epoch.valid_at = itow_valid_at_;
  of_epoch.device_time = itow;
  return of_epoch;
}

template <class Part>
requires requires(UbxEpoch& epoch, const Part& part, const Origin& o) { epoch.add(part, o); }
void GnssDriver::on(const Part& part, const Origin& origin, Output& out) {
  const Origin of_epoch = enter_epoch(part.itow, origin, out);
  if (closed_itow_ != part.itow) ubx_.add(part, of_epoch);  // otherwise the part came too late
}

void GnssDriver::on(const wire::NavEoe& eoe, const Origin& origin, Output& out) {
  enter_epoch(eoe.itow, origin, out);
  close_ubx_epoch(out);
}

void GnssDriver::close_ubx_epoch(Output& out) {
  if (ubx_.empty()) return;
  const auto fix = recent(pvt_at_, last_bytes_) ? std::nullopt : ubx_.fix();
  const auto satellites = recent(sat_at_, last_bytes_) ? std::nullopt : ubx_.satellites();
  closed_itow_ = itow_;
  ubx_.clear();
  if (fix) {
    fix_itow_ = itow_;
    ubx_fix_at_ = last_bytes_;
    publish_possible(*fix, out);
  }
  if (satellites) {
    satellites_itow_ = itow_;
    ubx_satellites_at_ = last_bytes_;
    out.publish(*satellites);
  }
}

void GnssDriver::on(const wire::NavPvt& pvt, const Origin& origin, Output& out) {
  GnssFix fix;
  fix.origin = enter_epoch(pvt.itow, origin, out);
  pvt_at_ = ubx_fix_at_ = origin.received_at;
  if (fix_itow_ == pvt.itow) return;  // it was polled or sent twice
  fix_itow_ = pvt.itow;

  fix.type = fix_type(pvt.fix_type, pvt.fix_ok);
  fix.quality = fix_quality(fix.type, pvt.differential, pvt.carrier_solution);
  if (pvt.date && pvt.time_of_day && pvt.date->ok()) {
    fix.utc = Stamp{std::chrono::sys_days{*pvt.date}.time_since_epoch() + *pvt.time_of_day};
  }
  if (pvt.latitude_rad && pvt.longitude_rad) fix.position = {*pvt.latitude_rad, *pvt.longitude_rad};
  fix.ellipsoidal_height_m = pvt.ellipsoidal_height_m;
  fix.mean_sea_level_height_m = pvt.mean_sea_level_height_m;
  if (pvt.velocity_north_mps && pvt.velocity_east_mps && pvt.velocity_down_mps) {
    fix.velocity_ned = {*pvt.velocity_north_mps, *pvt.velocity_east_mps, *pvt.velocity_down_mps};
  }
  fix.horizontal_accuracy_m = pvt.horizontal_accuracy_m;
  fix.vertical_accuracy_m = pvt.vertical_accuracy_m;
  fix.speed_accuracy_mps = pvt.speed_accuracy_mps;
  fix.position_dop = pvt.position_dop;
  fix.satellites_used = pvt.satellites_used;
  fix.ground_speed_mps = pvt.ground_speed_mps;
  fix.course_rad = pvt.course_rad;
  publish_possible(fix, out);
}

void GnssDriver::on(const wire::NavSat& sat, const Origin& origin, Output& out) {
  const Origin of_epoch = enter_epoch(sat.itow, origin, out);
  sat_at_ = ubx_satellites_at_ = origin.received_at;
  if (satellites_itow_ == sat.itow) return;
  satellites_itow_ = sat.itow;
  out.publish(measurement::GnssSatellites{of_epoch, satellite_list(sat.satellites)});
}

}  // namespace drydock::device
