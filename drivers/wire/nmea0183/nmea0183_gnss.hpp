#pragma once

#include <boost/container/static_vector.hpp>
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "drivers/wire/fields.hpp"
#include "drivers/wire/nmea0183/nmea0183_sentence.hpp"

/// NMEA 0183 sentences of a satellite receiver. A position, speed or course is empty if the
/// receiver marks it as invalid (quality 0, status V, mode N), even if its field has digits.
namespace drydock::wire {

/// Position fix.
struct Gga {
  static constexpr std::string_view type = "GGA";
  Talker talker{"GP"};
  std::optional<std::chrono::nanoseconds> time_of_day;  ///< UTC
  std::optional<double> latitude_rad, longitude_rad;
  std::optional<int> quality;  ///< 0 none, 1 GNSS, 2 differential, 4 RTK, 5 float, 6 estimated
  std::optional<int> satellites_used;
  std::optional<double> horizontal_dop;
  std::optional<double> mean_sea_level_height_m;
  std::optional<double> geoid_separation_m;  ///< geoid above ellipsoid
  std::optional<double> differential_age_s;
  std::optional<int> differential_station;
};

/// Recommended minimum: position, speed and course over ground, date.
struct Rmc {
  static constexpr std::string_view type = "RMC";
  Talker talker{"GP"};
  std::optional<std::chrono::nanoseconds> time_of_day;
  bool valid = false;  ///< status A
  std::optional<double> latitude_rad, longitude_rad;
  std::optional<double> speed_mps, course_rad;  ///< over ground, from true north
  std::optional<std::chrono::year_month_day> date;
  std::optional<double> magnetic_variation_rad;  ///< east positive
  Letter mode;                                   ///< A D E F M N P R S, since NMEA 2.3
  Letter nav_status;                             ///< S C U V, since NMEA 4.1
};

struct GsvSatellite {
  int number = 0;  ///< as sent: PRN, 33.. SBAS, 65.. GLONASS
  std::optional<double> elevation_rad, azimuth_rad;
  std::optional<double> cno_dbhz;  ///< empty: not tracked
};

/// Satellites in view, up to four in one sentence.
struct Gsv {
  static constexpr std::string_view type = "GSV";
  Talker talker{"GP"};
  std::optional<int> sentences, sentence_number;  ///< count in this group, and number from 1
  std::optional<int> satellites_in_view;
  boost::container::static_vector<GsvSatellite, 4> satellites;
  std::optional<int> signal;  ///< since NMEA 4.1; hexadecimal digit on the wire
};

/// Satellites used, and dilution of precision.
struct Gsa {
  static constexpr std::string_view type = "GSA";
  Talker talker{"GP"};
  Letter selection;             ///< M manual, A automatic
  std::optional<int> fix_type;  ///< 1 none, 2 2D, 3 3D
  boost::container::static_vector<int, 12> satellites_used;
  std::optional<double> position_dop, horizontal_dop, vertical_dop;
  std::optional<int> system;  ///< since NMEA 4.1: 1 GPS, 2 GLONASS, 3 Galileo, 4 BeiDou, ...
};

/// Course and speed over ground.
struct Vtg {
  static constexpr std::string_view type = "VTG";
  Talker talker{"GP"};
  std::optional<double> course_true_rad, course_magnetic_rad;
  std::optional<double> speed_mps;
  Letter mode;
};

/// Time and date.
struct Zda {
  static constexpr std::string_view type = "ZDA";
  Talker talker{"GP"};
  std::optional<std::chrono::nanoseconds> time_of_day;
  std::optional<std::chrono::year_month_day> date;
  std::optional<int> zone_hours, zone_minutes;
};

/// Each reads the fields after the address.
bool read(SentenceReader& fields, Gga& m);
bool read(SentenceReader& fields, Rmc& m);
bool read(SentenceReader& fields, Gsv& m);
bool read(SentenceReader& fields, Gsa& m);
bool read(SentenceReader& fields, Vtg& m);
bool read(SentenceReader& fields, Zda& m);

/// Returns the bytes written, 0 if `out` is too small.
std::size_t encode(const Gga& m, std::span<std::uint8_t> out, const NmeaDecimals& decimals = {});
std::size_t encode(const Rmc& m, std::span<std::uint8_t> out, const NmeaDecimals& decimals = {});
std::size_t encode(const Gsv& m, std::span<std::uint8_t> out);
std::size_t encode(const Gsa& m, std::span<std::uint8_t> out, const NmeaDecimals& decimals = {});
std::size_t encode(const Vtg& m, std::span<std::uint8_t> out, const NmeaDecimals& decimals = {});
std::size_t encode(const Zda& m, std::span<std::uint8_t> out, const NmeaDecimals& decimals = {});

template <class F>
void visit_fields(const Gga& m, F&& field) {
  field("talker", m.talker.text());
  field("time_of_day_s", seconds(m.time_of_day));
  field("latitude_deg", degrees(m.latitude_rad));
  field("longitude_deg", degrees(m.longitude_rad));
  field("quality", m.quality);
  field("satellites_used", m.satellites_used);
  field("horizontal_dop", m.horizontal_dop);
  field("mean_sea_level_height_m", m.mean_sea_level_height_m);
  field("geoid_separation_m", m.geoid_separation_m);
  field("differential_age_s", m.differential_age_s);
  field("differential_station", m.differential_station);
}

template <class F>
void visit_fields(const Rmc& m, F&& field) {
  field("talker", m.talker.text());
  field("time_of_day_s", seconds(m.time_of_day));
  field("valid", m.valid);
  field("latitude_deg", degrees(m.latitude_rad));
  field("longitude_deg", degrees(m.longitude_rad));
  field("speed_mps", m.speed_mps);
  field("course_deg", degrees(m.course_rad));
  visit_date(m.date, field);
  field("magnetic_variation_deg", degrees(m.magnetic_variation_rad));
  field("mode", m.mode.text());
  field("nav_status", m.nav_status.text());
}

template <class F>
void visit_fields(const GsvSatellite& m, F&& field) {
  field("number", m.number);
  field("elevation_deg", degrees(m.elevation_rad));
  field("azimuth_deg", degrees(m.azimuth_rad));
  field("cno_dbhz", m.cno_dbhz);
}

template <class F>
void visit_fields(const Gsv& m, F&& field) {
  field("talker", m.talker.text());
  field("sentences", m.sentences);
  field("sentence_number", m.sentence_number);
  field("satellites_in_view", m.satellites_in_view);
  field("satellites", std::span{m.satellites});
  field("signal", m.signal);
}

template <class F>
void visit_fields(const Gsa& m, F&& field) {
  field("talker", m.talker.text());
  field("selection", m.selection.text());
  field("fix_type", m.fix_type);
  field("satellites_used", std::span{m.satellites_used});
  field("position_dop", m.position_dop);
  field("horizontal_dop", m.horizontal_dop);
  field("vertical_dop", m.vertical_dop);
  field("system", m.system);
}

template <class F>
void visit_fields(const Vtg& m, F&& field) {
  field("talker", m.talker.text());
  field("course_true_deg", degrees(m.course_true_rad));
  field("course_magnetic_deg", degrees(m.course_magnetic_rad));
  field("speed_mps", m.speed_mps);
  field("mode", m.mode.text());
}

template <class F>
void visit_fields(const Zda& m, F&& field) {
  field("talker", m.talker.text());
  field("time_of_day_s", seconds(m.time_of_day));
  visit_date(m.date, field);
  field("zone_hours", m.zone_hours);
  field("zone_minutes", m.zone_minutes);
}

}  // namespace drydock::wire
