#include "drivers/device/gnss_driver.hpp"

namespace drydock::device {

using measurement::Constellation;
using measurement::FixType;
using measurement::GnssFix;
using std::chrono::milliseconds;

namespace {

/// USB adapters and schedulers hold bytes back for some tens of milliseconds, readers pass them on
/// in blocks: neither is the end of an epoch.
constexpr milliseconds shortest_pause{50};
constexpr milliseconds pause_without_baud{100};
constexpr std::size_t block_bytes = 128;

constexpr milliseconds late_within{500};  ///< a closed epoch's time again: a straggler
constexpr std::chrono::seconds ubx_counts_for{5};

bool recent(const std::optional<Stamp>& last, Stamp now) {
  return last && now - *last < ubx_counts_for;
}

FixType fix_type(const wire::NavPvt& pvt) {
  switch (pvt.fix_type) {
    case wire::UbxFixType::none: return FixType::none;
    case wire::UbxFixType::time_only: return FixType::time_only;
    case wire::UbxFixType::dead_reckoning:
      return pvt.fix_ok ? FixType::dead_reckoning : FixType::none;
    case wire::UbxFixType::two_d: return pvt.fix_ok ? FixType::two_d : FixType::none;
    case wire::UbxFixType::three_d: return pvt.fix_ok ? FixType::three_d : FixType::none;
    case wire::UbxFixType::gnss_and_dr: return pvt.fix_ok ? FixType::gnss_and_dr : FixType::none;
  }
  return FixType::none;
}

}  // namespace

GnssDriver::GnssDriver(const DriverOptions& options)
    : StreamDriver(options),
      scan_(options.protocol == wire::Nmea0183::name ? wire::Nmea0183::scan : wire::UbxNmea::scan),
      pause_(options.baud ? shortest_pause + timing_.line_time(block_bytes) : pause_without_baud) {}

void GnssDriver::receive(wire::Bytes bytes, Stamp received_at, Output& out) {
  tick(received_at, out);  // a pause before these bytes has ended the epoch, even if nobody ticked
  last_bytes_ = received_at;
  framer_.feed(bytes, scan_, [&](wire::Bytes frame, std::size_t after) {
    const auto message = wire::UbxNmea::decode(frame);
    if (!message) return;
    const Origin origin = timing_.of_bytes(received_at, frame.size(), after);
    std::visit(
        [&](const auto& m) {
          if constexpr (requires { on(m, origin, out); }) on(m, origin, out);
        },
        *message);
  });
}

std::optional<Stamp> GnssDriver::deadline() const {
  if (nmea_.empty()) return {};
  return last_bytes_ + pause_;
}

void GnssDriver::tick(Stamp now, Output& out) {
  const auto due = deadline();
  if (due && now >= *due) close_nmea_epoch(out);
}

void GnssDriver::restart(Stamp, Output&) {
  framer_.reset();
  nmea_.clear();
  closed_time_of_day_.reset();
  itow_.reset();
  published_itow_.reset();
}

template <class Sentence>
void GnssDriver::on_timed(const Sentence& sentence, const Origin& origin, Output& out) {
  if (nmea_.ends_before(sentence)) close_nmea_epoch(out);
  const bool straggler = nmea_.empty() && sentence.time_of_day &&
                         sentence.time_of_day == closed_time_of_day_ &&
                         origin.received_at - closed_at_ < late_within;
  if (!straggler) nmea_.add(sentence, origin);
}

void GnssDriver::close_nmea_epoch(Output& out) {
  if (nmea_.empty()) return;
  const auto fix = recent(pvt_at_, last_bytes_) ? std::nullopt : nmea_.fix();
  const auto satellites = recent(sat_at_, last_bytes_) ? std::nullopt : nmea_.satellites();
  closed_time_of_day_ = nmea_.time_of_day();
  closed_at_ = last_bytes_;
  nmea_.clear();
  if (fix) out.publish(*fix);
  if (satellites) out.publish(*satellites);
}

Origin GnssDriver::epoch_origin(milliseconds itow, const Origin& origin) {
  if (itow_ != itow) {
    itow_ = itow;
    itow_valid_at_ = origin.valid_at;
  }
  Origin of_epoch = origin;
  of_epoch.valid_at = itow_valid_at_;
  of_epoch.device_time = itow;
  return of_epoch;
}

void GnssDriver::on(const wire::NavPvt& pvt, const Origin& origin, Output& out) {
  GnssFix fix;
  fix.origin = epoch_origin(pvt.itow, origin);
  if (published_itow_ == pvt.itow) return;  // polled or sent twice
  published_itow_ = pvt.itow;
  pvt_at_ = origin.received_at;

  fix.type = fix_type(pvt);
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
  out.publish(fix);
}

void GnssDriver::on(const wire::NavSat& sat, const Origin& origin, Output& out) {
  measurement::GnssSatellites result;
  result.origin = epoch_origin(sat.itow, origin);
  sat_at_ = origin.received_at;
  for (const wire::UbxSatellite& s : sat.satellites) {
    if (s.gnss > wire::UbxGnss::navic) continue;
    if (result.satellites.size() == result.satellites.capacity()) break;
    result.satellites.push_back({static_cast<Constellation>(s.gnss), s.number, s.cno_dbhz,
                                 s.elevation_rad, s.azimuth_rad, s.used});
  }
  out.publish(result);
}

}  // namespace drydock::device
