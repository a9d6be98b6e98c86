#include <cmath>

#include "drivers/measurement/units.hpp"

#include "drivers/wire/nmea0183/nmea0183_gnss.hpp"

namespace drydock::wire {
namespace {

std::optional<int> rounded(const std::optional<double>& value) {
  return value ? std::optional{static_cast<int>(std::lround(*value))} : std::nullopt;
}

void write_short_date(SentenceWriter& out, const std::optional<std::chrono::year_month_day>& date) {
  std::optional<int> packed;
  if (date) {
    packed = static_cast<int>(static_cast<unsigned>(date->day()) * 10000 +
                              static_cast<unsigned>(date->month()) * 100) +
             static_cast<int>(date->year()) % 100;
  }
  out.integer(packed, 6);
}

}  // namespace

std::size_t encode(const Gga& m, std::span<std::uint8_t> out, const NmeaDecimals& decimals) {
  SentenceWriter w{out, m.talker, Gga::type};
  w.time(m.time_of_day, decimals.time);
  w.latitude(m.latitude_rad, decimals.minutes);
  w.longitude(m.longitude_rad, decimals.minutes);
  w.integer(m.quality);
  w.integer(m.satellites_used, 2);
  w.number(m.horizontal_dop, decimals.dop);
  w.number(m.mean_sea_level_height_m, decimals.height);
  w.letter('M');
  w.number(m.geoid_separation_m, decimals.height);
  w.letter('M');
  w.number(m.differential_age_s, 1);
  w.integer(m.differential_station, 4);
  return w.finish();
}

std::size_t encode(const Rmc& m, std::span<std::uint8_t> out, const NmeaDecimals& decimals) {
  SentenceWriter w{out, m.talker, Rmc::type};
  w.time(m.time_of_day, decimals.time);
  w.letter(m.valid ? 'A' : 'V');
  w.latitude(m.latitude_rad, decimals.minutes);
  w.longitude(m.longitude_rad, decimals.minutes);
  w.number(scaled(m.speed_mps, 1 / units::knot), decimals.speed);
  w.angle(m.course_rad, decimals.angle);
  write_short_date(w, m.date);
  w.eastward(m.magnetic_variation_rad, decimals.angle);
  if (m.mode.value || m.nav_status.value) w.letter(m.mode);
  if (m.nav_status.value) w.letter(m.nav_status);
  return w.finish();
}

std::size_t encode(const Gsv& m, std::span<std::uint8_t> out) {
  SentenceWriter w{out, m.talker, Gsv::type};
  w.integer(m.sentences);
  w.integer(m.sentence_number);
  w.integer(m.satellites_in_view, 2);
  for (const GsvSatellite& satellite : m.satellites) {
    w.integer(satellite.number, 2);
    w.integer(rounded(degrees(satellite.elevation_rad)), 2);
    w.integer(rounded(degrees(satellite.azimuth_rad)), 3);
    w.integer(rounded(satellite.cno_dbhz), 2);
  }
  if (m.signal) w.hexadecimal(m.signal);
  return w.finish();
}

std::size_t encode(const Gsa& m, std::span<std::uint8_t> out, const NmeaDecimals& decimals) {
  SentenceWriter w{out, m.talker, Gsa::type};
  w.letter(m.selection);
  w.integer(m.fix_type);
  for (std::size_t i = 0; i < m.satellites_used.capacity(); ++i) {
    w.integer(i < m.satellites_used.size() ? std::optional{m.satellites_used[i]} : std::nullopt, 2);
  }
  w.number(m.position_dop, decimals.dop);
  w.number(m.horizontal_dop, decimals.dop);
  w.number(m.vertical_dop, decimals.dop);
  if (m.system) w.hexadecimal(m.system);
  return w.finish();
}

std::size_t encode(const Vtg& m, std::span<std::uint8_t> out, const NmeaDecimals& decimals) {
  SentenceWriter w{out, m.talker, Vtg::type};
  w.angle(m.course_true_rad, decimals.angle);
  w.letter('T');
  w.angle(m.course_magnetic_rad, decimals.angle);
  w.letter('M');
  w.number(scaled(m.speed_mps, 1 / units::knot), decimals.speed);
  w.letter('N');
  w.number(scaled(m.speed_mps, 1 / units::kilometre_per_hour), decimals.speed);
  w.letter('K');
  if (m.mode.value) w.letter(m.mode);
  return w.finish();
}

std::size_t encode(const Zda& m, std::span<std::uint8_t> out, const NmeaDecimals& decimals) {
  using Number = std::optional<int>;
  SentenceWriter w{out, m.talker, Zda::type};
  w.time(m.time_of_day, decimals.time);
  w.integer(m.date ? Number{static_cast<unsigned>(m.date->day())} : std::nullopt, 2);
  w.integer(m.date ? Number{static_cast<unsigned>(m.date->month())} : std::nullopt, 2);
  w.integer(m.date ? Number{static_cast<int>(m.date->year())} : std::nullopt, 4);
  w.integer(m.zone_hours, 2);
  w.integer(m.zone_minutes, 2);
  return w.finish();
}

}  // namespace drydock::wire
