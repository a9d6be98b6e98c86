#include "drivers/device/gnss/nmea2000_gnss_driver.hpp"

#include "drivers/device/gnss/gnss_gate.hpp"
#include "drivers/measurement/earlier.hpp"

namespace drydock::device {

namespace {

namespace n2k = wire::nmea2000;

constexpr std::chrono::milliseconds receiver_pause{100};
constexpr std::chrono::seconds position_counts_for{5}, course_counts_for{1};

bool is_recent(const std::optional<Stamp>& last, Stamp now, std::chrono::nanoseconds within) {
  return last && now - *last < within;
}

bool begins_packet(const wire::j1939::Identifier& id, const wire::CanFrame& frame) {
  const bool is_packet = id.pgn == n2k::GnssPosition::pgn || id.pgn == n2k::SatellitesInView::pgn;
  return is_packet && wire::begins_fast_packet(frame.payload());
}

}  // namespace

Nmea2000GnssDriver::Nmea2000GnssDriver(const DriverOptions& options)
    : Nmea2000Driver(options), source_(options.address) {}

void Nmea2000GnssDriver::receive(const wire::CanFrame& frame, Stamp received_at, Output& out) {
  tick(received_at, out);  // a pause before this frame has ended the epoch, even without a tick
  const Origin origin = timing_.of_frame(received_at, frame);
  note_begin(frame, origin);
  const auto message = decoder_.receive(frame, received_at.time_since_epoch());
  if (!message) return;
  std::visit(
      [&](const auto& m) {
        if constexpr (requires { on(m, origin, out); }) on(m, origin, out);
      },
      *message);
}

void Nmea2000GnssDriver::note_begin(const wire::CanFrame& frame, const Origin& origin) {
  const auto id = wire::j1939::identify(frame);
  if (!id || !begins_packet(*id, frame)) return;
  if (source_.source().value_or(id->source) == id->source) begin_ = {id->source, origin};
}

Origin Nmea2000GnssDriver::of_packet(std::uint8_t source, const Origin& last) const {
  Origin origin = last;
  if (begin_.source == source) origin.valid_at = begin_.origin.valid_at;
  return origin;
}

std::optional<Stamp> Nmea2000GnssDriver::epoch_ends_at() const {
  if (epoch_.empty()) return {};
  return epoch_.last_part_at() + receiver_pause;
}

std::optional<Stamp> Nmea2000GnssDriver::deadline() const {
  return measurement::earlier(Nmea2000Driver::deadline(), epoch_ends_at());
}

void Nmea2000GnssDriver::tick(Stamp now, Output& out) {
  Nmea2000Driver::tick(now, out);
  if (const auto due = epoch_ends_at(); due && *due <= now) close(out);
}

void Nmea2000GnssDriver::restart(Stamp now, Output& out) {
  Nmea2000Driver::restart(now, out);
  epoch_.clear();
  position_at_ = course_at_ = std::nullopt;
}

void Nmea2000GnssDriver::close(Output& out) {
  const auto fix = epoch_.fix();
  epoch_.clear();
  if (fix) publish_possible(*fix, out);
}

template <class Part>
void Nmea2000GnssDriver::add(const Part& part, const Origin& origin, Output& out) {
  if (epoch_.ends_before(part, origin)) close(out);
  epoch_.add(part, origin);
}

void Nmea2000GnssDriver::on(const n2k::GnssPosition& position, const Origin& origin, Output& out) {
  if (!accepts(source_, position.source, origin.received_at)) return;
  position_at_ = origin.received_at;
  add(position, of_packet(position.source, origin), out);
}

void Nmea2000GnssDriver::on(const n2k::CourseAndSpeed& course, const Origin& origin, Output& out) {
  if (!accepts(source_, course.source, origin.received_at)) return;
  course_ = course;
  course_at_ = origin.received_at;
  add(course, origin, out);
}

void Nmea2000GnssDriver::on(const n2k::Dilutions& dilutions, const Origin& origin, Output& out) {
  if (accepts(source_, dilutions.source, origin.received_at)) add(dilutions, origin, out);
}

void Nmea2000GnssDriver::on(const n2k::SatellitesInView& sky, const Origin& origin, Output& out) {
  if (!accepts(source_, sky.source, origin.received_at)) return;
  Origin of_sky = of_packet(sky.source, origin);
  of_sky.valid_at = epoch_.valid_at(sky.sequence).value_or(of_sky.valid_at);
  out.publish(satellites_of(sky, of_sky));
}

void Nmea2000GnssDriver::on(const n2k::RapidPosition& position, const Origin& origin, Output& out) {
  if (!accepts(source_, position.source, origin.received_at)) return;
  if (is_recent(position_at_, origin.received_at, position_counts_for)) return;
  measurement::GnssFix fix;
  fix.origin = origin;
  if (position.latitude_rad && position.longitude_rad) {
    fix.type = measurement::FixType::two_d;
    fix.position = measurement::Geodetic{*position.latitude_rad, *position.longitude_rad};
    if (is_recent(course_at_, origin.received_at, course_counts_for)) fill_motion(fix, course_);
  }
  publish_possible(fix, out);
}

void Nmea2000GnssDriver::on(const wire::j1939::AddressClaimed& claim, const Origin& origin,
                            Output&) {
  source_.claimed(claim.source, claim.name, origin.received_at);
}

}  // namespace drydock::device
