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

constexpr milliseconds late_within = EpochPause::longest;  ///< it came late, after its epoch
/// A receiver without a fix may tell one time again and again: the epoch of such a time ends too.
constexpr std::chrono::seconds longest_epoch{2};
constexpr std::chrono::seconds counts_for{5};  ///< a better message replaces others

void refuse_late(std::string_view what, Output& out) {
  Reason why{what};
  why += " came after the epoch to which it belongs, and was left out";
  out.refuse(why.view(), Refusal::incomplete);
}

bool recent(const std::optional<Stamp>& last, Stamp now) {
  return last && now - *last < counts_for;
}

}  // namespace

GnssDriver::GnssDriver(const DriverOptions& options)
    : StreamDriver(options, options.protocol == wire::Nmea0183::name ? wire::Nmea0183::scan
                                                                     : wire::UbxNmea::scan),
      pause_(
          options.baud ? pause_between_epochs + timing_.line_time(block_bytes) : pause_without_baud,
          options.baud.has_value()),
      setup_(options.ublox) {}

void GnssDriver::receive(wire::Bytes bytes, Stamp received_at, Output& out) {
  tick(received_at, out);  // a pause before these bytes has ended the epoch, even without a tick
  last_bytes_ = received_at;
  StreamDriver::receive(bytes, received_at, out);
}

void GnssDriver::on_frame(wire::Bytes frame, const Arrival& arrival, Output& out) {
  setup_.receive(frame, arrival.read_at, out);
  const auto message = wire::UbxNmea::decode(frame);
  if (!message) return;
  const Origin origin = timing_.of_bytes(arrival);
  damaged_ = timing_.line_time(arrival.skipped);
  std::visit(
      [&](const auto& m) {
        if constexpr (requires { on(m, origin, out); }) on(m, origin, out);
      },
      *message);
}

std::optional<Stamp> GnssDriver::epoch_ends_at() const {
  if (nmea_.empty() && ubx_.empty()) return {};
  return last_bytes_ + pause_.length();
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
  talker_.forget();
  date_.forget();
  nmea_begin_.forget();
  ubx_begin_.forget();
  closed_time_of_day_.reset();
  itow_ = fix_itow_ = satellites_itow_ = closed_itow_ = std::nullopt;
  pvt_at_ = sat_at_ = ubx_fix_at_ = ubx_satellites_at_ = std::nullopt;
  // A recording contains the answers at their own times, so it plays as it was recorded.
  setup_.expect_no_answers(timing_.provenance() == measurement::Provenance::replayed);
  setup_.start(now, out);
}

bool GnssDriver::is_of_receiver(wire::Talker talker, bool tells_position, const Origin& origin,
                                Output& out) {
  if (!talker_.counts(talker, tells_position, origin.received_at)) {
    Reason why{"two receivers on one line: "};
    why += talker_.chosen().text();
    why += " counts, sentences of ";
    why += talker.text();
    why += " were left out";
    out.refuse(why.view(), Refusal::of_another);
    return false;
  }
  if (talker_.changed()) {  // what the other one told belongs to no epoch of this one
    nmea_.clear();
    closed_time_of_day_.reset();
  }
  return true;
}

/// Ends the epoch that is open if the sentence is of another one. What stands in front of the first
/// time on a line, and apart from it, is the end of an epoch that was not heard.
template <class Sentence>
void GnssDriver::begin_or_go_on(const Sentence& sentence, const Origin& origin, Output& out) {
  const bool of_unheard = !closed_time_of_day_ && !nmea_.time_of_day() && requires {
    sentence.time_of_day;
  }
  &&nmea_.since_last(origin.received_at) > pause_without_baud;
  if (of_unheard || nmea_.ends_before(sentence) ||
      nmea_.since_first(origin.received_at) > longest_epoch)
    close_nmea_epoch(out);
  else
    pause_.was_inside(nmea_.since_last(origin.received_at));
  if (nmea_.empty()) nmea_damaged_ = damaged_;
}

template <class Sentence>
void GnssDriver::on_timed(const Sentence& sentence, const Origin& origin, Output& out) {
  constexpr bool tells_position = requires { sentence.latitude_rad; };
  if (!is_of_receiver(sentence.talker, tells_position, origin, out)) return;
  begin_or_go_on(sentence, origin, out);
  const bool straggler = !nmea_.time_of_day() &&
                         NmeaEpoch::is_same(sentence.time_of_day, closed_time_of_day_) &&
                         origin.received_at - closed_at_ < late_within;
  if (!straggler) return nmea_.add(sentence, origin);
  pause_.was_inside(origin.received_at - closed_at_);
  refuse_late(Sentence::type, out);
}

template <class Sentence>
void GnssDriver::on_untimed(const Sentence& sentence, const Origin& origin, Output& out) {
  if (!is_of_receiver(sentence.talker, false, origin, out)) return;
  begin_or_go_on(sentence, origin, out);
  nmea_.add(sentence, origin);
}

void GnssDriver::close_nmea_epoch(Output& out) {
  if (nmea_.empty()) return;
  if (const auto& time = nmea_.time_of_day())
    nmea_.set_valid_at(nmea_begin_.of(nmea_.valid_at(), *time, nmea_damaged_));
  const bool fix_told = recent(ubx_fix_at_, last_bytes_) || ubx_.fix();
  const bool satellites_told = recent(ubx_satellites_at_, last_bytes_) || ubx_.satellites();
  auto fix = fix_told ? std::nullopt : nmea_.fix();
  const auto satellites = satellites_told ? std::nullopt : nmea_.satellites();
  if (const auto utc = nmea_.utc()) date_.told(*utc, last_bytes_);
  if (fix && fix->type != measurement::FixType::none && !fix->utc && nmea_.time_of_day())
    fix->utc = date_.of(*nmea_.time_of_day(), last_bytes_);
  if (nmea_.time_of_day()) closed_time_of_day_ = nmea_.time_of_day();
  closed_at_ = last_bytes_;
  nmea_.clear();
  pause_.epoch_is_over();
  if (fix) publish_possible(*fix, out);
  if (satellites) out.publish(*satellites);
}

Origin GnssDriver::enter_epoch(milliseconds itow, const Origin& origin, Output& out) {
  if (itow_ != itow) {
    close_ubx_epoch(out);
    itow_ = itow;
    itow_valid_at_ = ubx_begin_.of(origin.valid_at, itow, damaged_);
  } else {
    pause_.was_inside(origin.received_at - itow_received_at_);
  }
  itow_received_at_ = origin.received_at;
  Origin of_epoch = origin;
  of_epoch.valid_at = itow_valid_at_;
  of_epoch.device_time = itow;
  return of_epoch;
}

template <class Part>
requires requires(UbxEpoch& epoch, const Part& part, const Origin& o) { epoch.add(part, o); }
void GnssDriver::on(const Part& part, const Origin& origin, Output& out) {
  const Origin of_epoch = enter_epoch(part.itow, origin, out);
  if (closed_itow_ == part.itow) return refuse_late(Part::type, out);
  ubx_.add(part, of_epoch);
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
  pause_.epoch_is_over();
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
