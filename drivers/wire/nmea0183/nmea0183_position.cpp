#include "drivers/wire/nmea0183/nmea0183_position.hpp"

#include <algorithm>

namespace drydock::wire {

bool read(SentenceReader& fields, Gns& m) {
  m.talker = fields.talker();
  m.time_of_day = fields.time();
  fields.position(m.latitude_rad, m.longitude_rad);
  const std::string_view modes = fields.text();
  m.modes.assign(modes.begin(), modes.begin() + std::min(modes.size(), m.modes.capacity()));
  m.satellites_used = fields.integer();
  m.horizontal_dop = dilution(fields.number());
  m.mean_sea_level_height_m = fields.number();
  m.geoid_separation_m = fields.number();
  m.differential_age_s = fields.number();
  m.differential_station = fields.integer();
  m.nav_status = fields.letter();
  // Mode N means that a constellation gave no fix. Without any other mode the position is not
  // valid. A field without a mode says nothing.
  const bool no_mode = modes.find_first_not_of(' ') == std::string_view::npos;
  if (no_mode ? m.satellites_used == 0 : modes.find_first_not_of("N ") == std::string_view::npos) {
    m.latitude_rad = m.longitude_rad = m.mean_sea_level_height_m = std::nullopt;
  }
  return true;
}

bool read(SentenceReader& fields, Gll& m) {
  m.talker = fields.talker();
  fields.position(m.latitude_rad, m.longitude_rad);
  m.time_of_day = fields.time();
  m.valid = fields.letter().value == 'A';
  m.mode = fields.letter();
  m.valid = m.valid && m.mode.value != 'N';
  if (!m.valid) m.latitude_rad = m.longitude_rad = std::nullopt;
  return true;
}

bool read(SentenceReader& fields, Gst& m) {
  m.talker = fields.talker();
  m.time_of_day = fields.time();
  m.range_rms_m = fields.number();
  m.semi_major_m = fields.number();
  m.semi_minor_m = fields.number();
  m.orientation_rad = fields.angle();
  m.latitude_sigma_m = fields.number();
  m.longitude_sigma_m = fields.number();
  m.height_sigma_m = fields.number();
  return true;
}

std::size_t encode(const Gns& m, std::span<std::uint8_t> out, const NmeaDecimals& decimals) {
  SentenceWriter w{out, m.talker, Gns::type};
  w.time(m.time_of_day, decimals.time);
  w.latitude(m.latitude_rad, decimals.minutes);
  w.longitude(m.longitude_rad, decimals.minutes);
  w.text({m.modes.data(), m.modes.size()});
  w.integer(m.satellites_used, 2);
  w.number(m.horizontal_dop, decimals.dop);
  w.number(m.mean_sea_level_height_m, decimals.height);
  w.number(m.geoid_separation_m, decimals.height);
  w.number(m.differential_age_s, 1);
  w.integer(m.differential_station, 4);
  if (m.nav_status.value) w.letter(m.nav_status);
  return w.finish();
}

std::size_t encode(const Gll& m, std::span<std::uint8_t> out, const NmeaDecimals& decimals) {
  SentenceWriter w{out, m.talker, Gll::type};
  w.latitude(m.latitude_rad, decimals.minutes);
  w.longitude(m.longitude_rad, decimals.minutes);
  w.time(m.time_of_day, decimals.time);
  w.letter(m.valid ? 'A' : 'V');
  if (m.mode.value) w.letter(m.mode);
  return w.finish();
}

std::size_t encode(const Gst& m, std::span<std::uint8_t> out, const NmeaDecimals& decimals) {
  SentenceWriter w{out, m.talker, Gst::type};
  w.time(m.time_of_day, decimals.time);
  w.number(m.range_rms_m, decimals.distance);
  w.number(m.semi_major_m, decimals.distance);
  w.number(m.semi_minor_m, decimals.distance);
  w.angle(m.orientation_rad, decimals.angle);
  w.number(m.latitude_sigma_m, decimals.distance);
  w.number(m.longitude_sigma_m, decimals.distance);
  w.number(m.height_sigma_m, decimals.distance);
  return w.finish();
}

}  // namespace drydock::wire
