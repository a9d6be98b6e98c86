#pragma once

#include <boost/container/static_vector.hpp>
#include <chrono>
#include <optional>
#include <span>
#include <string_view>

#include "drivers/wire/fields.hpp"
#include "drivers/wire/nmea0183/nmea0183_sentence.hpp"

/// NMEA 0183 sentences with a position or its accuracy, other than GGA and RMC. Values that the
/// receiver marks as invalid are empty.
namespace drydock::wire {

/// Position fix of several constellations.
struct Gns {
  static constexpr std::string_view type = "GNS";
  Talker talker{"GN"};
  std::optional<std::chrono::nanoseconds> time_of_day;  ///< UTC
  std::optional<double> latitude_rad, longitude_rad;
  /// One letter for each of GPS, GLONASS, Galileo, BeiDou, QZSS, NavIC: N none, A autonomous,
  /// D differential, P precise, R RTK, F float, E estimated, M manual, S simulated.
  boost::container::static_vector<char, 8> modes;
  std::optional<int> satellites_used;
  std::optional<double> horizontal_dop;
  std::optional<double> mean_sea_level_height_m;
  std::optional<double> geoid_separation_m;  ///< geoid above ellipsoid
  std::optional<double> differential_age_s;
  std::optional<int> differential_station;
  Letter nav_status;  ///< S C U V, since NMEA 4.1
};

/// Position of any receiver, not only of satellites.
struct Gll {
  static constexpr std::string_view type = "GLL";
  Talker talker{"GP"};
  std::optional<double> latitude_rad, longitude_rad;
  std::optional<std::chrono::nanoseconds> time_of_day;
  bool valid = false;  ///< status A
  Letter mode;         ///< A D E M N S, since NMEA 2.3
};

/// Accuracy of the position, 1 sigma.
struct Gst {
  static constexpr std::string_view type = "GST";
  Talker talker{"GP"};
  std::optional<std::chrono::nanoseconds> time_of_day;
  std::optional<double> range_rms_m;
  std::optional<double> semi_major_m, semi_minor_m, orientation_rad;  ///< from true north
  std::optional<double> latitude_sigma_m, longitude_sigma_m, height_sigma_m;
};

/// Each reads the fields after the address.
bool read(SentenceReader& fields, Gns& m);
bool read(SentenceReader& fields, Gll& m);
bool read(SentenceReader& fields, Gst& m);

/// Returns the bytes written, 0 if `out` is too small.
std::size_t encode(const Gns& m, std::span<std::uint8_t> out, const NmeaDecimals& decimals = {});
std::size_t encode(const Gll& m, std::span<std::uint8_t> out, const NmeaDecimals& decimals = {});
std::size_t encode(const Gst& m, std::span<std::uint8_t> out, const NmeaDecimals& decimals = {});

template <class F>
void visit_fields(const Gns& m, F&& field) {
  field("talker", m.talker.text());
  field("time_of_day_s", seconds(m.time_of_day));
  field("latitude_deg", degrees(m.latitude_rad));
  field("longitude_deg", degrees(m.longitude_rad));
  field("modes", std::string_view{m.modes.data(), m.modes.size()});
  field("satellites_used", m.satellites_used);
  field("horizontal_dop", m.horizontal_dop);
  field("mean_sea_level_height_m", m.mean_sea_level_height_m);
  field("geoid_separation_m", m.geoid_separation_m);
  field("differential_age_s", m.differential_age_s);
  field("differential_station", m.differential_station);
  field("nav_status", m.nav_status.text());
}

template <class F>
void visit_fields(const Gll& m, F&& field) {
  field("talker", m.talker.text());
  field("latitude_deg", degrees(m.latitude_rad));
  field("longitude_deg", degrees(m.longitude_rad));
  field("time_of_day_s", seconds(m.time_of_day));
  field("valid", m.valid);
  field("mode", m.mode.text());
}

template <class F>
void visit_fields(const Gst& m, F&& field) {
  field("talker", m.talker.text());
  field("time_of_day_s", seconds(m.time_of_day));
  field("range_rms_m", m.range_rms_m);
  field("semi_major_m", m.semi_major_m);
  field("semi_minor_m", m.semi_minor_m);
  field("orientation_deg", degrees(m.orientation_rad));
  field("latitude_sigma_m", m.latitude_sigma_m);
  field("longitude_sigma_m", m.longitude_sigma_m);
  field("height_sigma_m", m.height_sigma_m);
}

}  // namespace drydock::wire
