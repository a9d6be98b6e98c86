#include "drivers/wire/nmea0183/nmea0183_speed.hpp"

#include "drivers/measurement/units.hpp"

namespace drydock::wire {
namespace {

using Value = std::optional<double>;

/// Reads the speeds (along and across, or one of them) and their status.
template <class... V>
void read_speeds(SentenceReader& fields, V&... speeds) {
  ((speeds = scaled(fields.number(), units::knot)), ...);
  if (fields.letter().value != 'A') ((speeds = std::nullopt), ...);
}

template <class... V>
void write_speeds(SentenceWriter& out, int decimals, const V&... speeds) {
  (out.number(scaled(speeds, 1 / units::knot), decimals), ...);
  out.letter((speeds || ...) ? 'A' : 'V');
}

/// False if it is not in nautical miles.
bool read_distance(SentenceReader& fields, Value& distance_m) {
  distance_m = scaled(fields.number(), units::nautical_mile);
  return fields.fixed('N');
}

void write_distance(SentenceWriter& out, const Value& distance_m, int decimals) {
  out.number(scaled(distance_m, 1 / units::nautical_mile), decimals);
  out.letter('N');
}

}  // namespace

bool read(SentenceReader& fields, Vhw& m) {
  m.talker = fields.talker();
  m.heading_true_rad = fields.angle();
  if (!fields.fixed('T')) return false;
  m.heading_magnetic_rad = fields.angle();
  if (!fields.fixed('M')) return false;
  const Value knots = fields.number();
  if (!fields.fixed('N')) return false;
  const Value kilometres_per_hour = fields.number();
  m.speed_mps =
      knots ? scaled(knots, units::knot) : scaled(kilometres_per_hour, units::kilometre_per_hour);
  return fields.fixed('K');
}

bool read(SentenceReader& fields, Vbw& m) {
  m.talker = fields.talker();
  read_speeds(fields, m.water_longitudinal_mps, m.water_transverse_mps);
  read_speeds(fields, m.ground_longitudinal_mps, m.ground_transverse_mps);
  read_speeds(fields, m.water_stern_transverse_mps);
  read_speeds(fields, m.ground_stern_transverse_mps);
  return true;
}

bool read(SentenceReader& fields, Vlw& m) {
  m.talker = fields.talker();
  return read_distance(fields, m.water_total_m) && read_distance(fields, m.water_trip_m) &&
         read_distance(fields, m.ground_total_m) && read_distance(fields, m.ground_trip_m);
}

std::size_t encode(const Vhw& m, std::span<std::uint8_t> out, const NmeaDecimals& decimals) {
  SentenceWriter w{out, m.talker, Vhw::type};
  w.angle(m.heading_true_rad, decimals.angle);
  w.letter('T');
  w.angle(m.heading_magnetic_rad, decimals.angle);
  w.letter('M');
  w.number(scaled(m.speed_mps, 1 / units::knot), decimals.speed);
  w.letter('N');
  w.number(scaled(m.speed_mps, 1 / units::kilometre_per_hour), decimals.speed);
  w.letter('K');
  return w.finish();
}

std::size_t encode(const Vbw& m, std::span<std::uint8_t> out, const NmeaDecimals& decimals) {
  SentenceWriter w{out, m.talker, Vbw::type};
  write_speeds(w, decimals.speed, m.water_longitudinal_mps, m.water_transverse_mps);
  write_speeds(w, decimals.speed, m.ground_longitudinal_mps, m.ground_transverse_mps);
  write_speeds(w, decimals.speed, m.water_stern_transverse_mps);
  write_speeds(w, decimals.speed, m.ground_stern_transverse_mps);
  return w.finish();
}

std::size_t encode(const Vlw& m, std::span<std::uint8_t> out, const NmeaDecimals& decimals) {
  SentenceWriter w{out, m.talker, Vlw::type};
  write_distance(w, m.water_total_m, decimals.distance);
  write_distance(w, m.water_trip_m, decimals.distance);
  write_distance(w, m.ground_total_m, decimals.distance);
  write_distance(w, m.ground_trip_m, decimals.distance);
  return w.finish();
}

}  // namespace drydock::wire
