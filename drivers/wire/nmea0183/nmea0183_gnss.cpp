#include "drivers/wire/nmea0183/nmea0183_gnss.hpp"

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "drivers/measurement/units.hpp"

namespace drydock::wire {
namespace {

using std::chrono::day;
using std::chrono::month;
using std::chrono::year;
using std::chrono::year_month_day;

std::optional<year_month_day> checked(year_month_day date) {
  return date.ok() ? std::optional{date} : std::nullopt;
}

/// ddmmyy. GPS time began in 1980.
std::optional<year_month_day> read_short_date(SentenceReader& fields) {
  const std::string_view text = fields.text();
  if (text.size() != 6) return std::nullopt;
  std::array<int, 6> digit;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] < '0' || text[i] > '9') return std::nullopt;
    digit[i] = text[i] - '0';
  }
  const int short_year = digit[4] * 10 + digit[5];
  return checked({year{short_year < 80 ? 2000 + short_year : 1900 + short_year},
                  month{static_cast<unsigned>(digit[2] * 10 + digit[3])},
                  day{static_cast<unsigned>(digit[0] * 10 + digit[1])}});
}

std::optional<year_month_day> read_long_date(SentenceReader& fields) {
  const auto d = fields.integer(), m = fields.integer(), y = fields.integer();
  if (!d || !m || !y || *d < 0 || *m < 0) return std::nullopt;
  return checked({year{*y}, month{static_cast<unsigned>(*m)}, day{static_cast<unsigned>(*d)}});
}

std::optional<int> within(std::optional<int> number, int most) {
  return number && std::abs(*number) <= most ? number : std::nullopt;
}

/// A speed over the ground has no sign: its course tells where to.
std::optional<double> read_speed(SentenceReader& fields, double unit) {
  const auto speed = fields.number();
  return speed && *speed >= 0 ? scaled(speed, unit) : std::nullopt;
}

}  // namespace

bool read(SentenceReader& fields, Gga& m) {
  m.talker = fields.talker();
  m.time_of_day = fields.time();
  fields.position(m.latitude_rad, m.longitude_rad);
  m.quality = fields.integer();
  m.satellites_used = fields.integer();
  m.horizontal_dop = dilution(fields.number());
  m.mean_sea_level_height_m = fields.number();
  bool metres = fields.fixed('M');
  m.geoid_separation_m = fields.number();
  metres = fields.fixed('M') && metres;
  m.differential_age_s = fields.number();
  m.differential_station = fields.integer();
  if (m.quality.value_or(0) <= 0) {
    m.latitude_rad = m.longitude_rad = m.mean_sea_level_height_m = std::nullopt;
  }
  return metres;
}

bool read(SentenceReader& fields, Rmc& m) {
  m.talker = fields.talker();
  m.time_of_day = fields.time();
  m.valid = fields.letter().value == 'A';
  fields.position(m.latitude_rad, m.longitude_rad);
  m.speed_mps = read_speed(fields, units::knot);
  m.course_rad = fields.direction();
  m.date = read_short_date(fields);
  m.magnetic_variation_rad = fields.eastward();
  m.mode = fields.letter();
  m.nav_status = fields.letter();
  m.valid = m.valid && m.mode.value != 'N';
  if (!m.valid) {
    m.latitude_rad = m.longitude_rad = m.speed_mps = m.course_rad = std::nullopt;
  }
  return true;
}

bool read(SentenceReader& fields, Gsv& m) {
  m.talker = fields.talker();
  m.sentences = fields.integer();
  m.sentence_number = fields.integer();
  m.satellites_in_view = fields.integer();
  std::size_t remaining = fields.remaining();
  for (; remaining >= 4 && m.satellites.size() < m.satellites.capacity(); remaining -= 4) {
    const auto number = fields.integer();
    auto elevation = fields.angle(), azimuth = fields.angle();
    const auto cno = fields.number();
    if (!number) continue;
    if (elevation && std::abs(*elevation) > std::numbers::pi / 2) elevation = std::nullopt;
    if (azimuth && (*azimuth < 0 || *azimuth > 2 * std::numbers::pi)) azimuth = std::nullopt;
    m.satellites.push_back({.number = *number,
                            .elevation_rad = elevation,
                            .azimuth_rad = azimuth,
                            .cno_dbhz = cno.value_or(0) > 0 ? cno : std::nullopt});
  }
  if (remaining == 1) m.signal = fields.hexadecimal();
  return true;
}

bool read(SentenceReader& fields, Gsa& m) {
  m.talker = fields.talker();
  m.selection = fields.letter();
  m.fix_type = fields.integer();
  for (std::size_t i = 0; i < m.satellites_used.capacity(); ++i) {
    if (const auto number = fields.integer()) m.satellites_used.push_back(*number);
  }
  m.position_dop = dilution(fields.number());
  m.horizontal_dop = dilution(fields.number());
  m.vertical_dop = dilution(fields.number());
  m.system = fields.hexadecimal();
  return true;
}

/// Before version 2 of the standard it had four numbers and no letters between them.
bool read(SentenceReader& fields, Vtg& m) {
  constexpr std::size_t numbers_alone = 4;
  const bool lettered = fields.remaining() != numbers_alone;
  bool as_known = true;
  const auto expect = [&](char letter) {
    if (lettered) as_known = fields.fixed(letter) && as_known;
  };
  m.talker = fields.talker();
  m.course_true_rad = fields.direction();
  expect('T');
  m.course_magnetic_rad = fields.direction();
  expect('M');
  const auto of_knots = read_speed(fields, units::knot);
  expect('N');
  const auto of_kilometres = read_speed(fields, units::kilometre_per_hour);
  expect('K');
  m.speed_mps = of_knots ? of_knots : of_kilometres;
  m.mode = fields.letter();
  if (m.mode.value == 'N') {
    m.course_true_rad = m.course_magnetic_rad = m.speed_mps = std::nullopt;
  }
  return as_known;
}

bool read(SentenceReader& fields, Zda& m) {
  m.talker = fields.talker();
  m.time_of_day = fields.time();
  m.date = read_long_date(fields);
  constexpr int most_hours = 13, most_minutes = 59;  // of IEC 61162-1; either way from UTC
  m.zone_hours = within(fields.integer(), most_hours);
  m.zone_minutes = within(fields.integer(), most_minutes);
  return true;
}

}  // namespace drydock::wire
