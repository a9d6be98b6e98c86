#pragma once

#include <boost/container/static_vector.hpp>
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "drivers/wire/codec.hpp"
#include "drivers/wire/fields.hpp"

/// Navigation messages of u-blox receivers, class 0x01 (u-blox interface descriptions, M8 to F9).
namespace drydock::wire {

enum class UbxFixType : std::uint8_t {
  none,
  dead_reckoning,
  two_d,
  three_d,
  gnss_and_dr,
  time_only
};

/// True if the receiver calls its position and velocity valid: gnssFixOK, and a fix type from 2D to
/// GNSS with dead reckoning.
constexpr bool vouched_for(UbxFixType type, bool fix_ok) {
  return fix_ok && type >= UbxFixType::two_d && type <= UbxFixType::gnss_and_dr;
}

/// Position, velocity, time. Values that the receiver does not call valid are empty; invalidLlh
/// also makes the position empty.
struct NavPvt {
  static constexpr std::string_view type = "NAV-PVT";
  static constexpr std::uint16_t class_and_id = 0x0107;
  NavPvt() {}                        // read in place, see message_list.hpp
  std::chrono::milliseconds itow{};  ///< GPS time of week
  std::optional<std::chrono::year_month_day> date;
  /// UTC since midnight of `date`. The receiver rounds to hundredths and adds a signed rest, so
  /// the value may be slightly negative.
  std::optional<std::chrono::nanoseconds> time_of_day;
  bool time_resolved = false;  ///< whole seconds are no longer ambiguous
  std::optional<double> time_accuracy_s;

  UbxFixType fix_type = UbxFixType::none;
  bool fix_ok = false;  ///< within the receiver's DOP and accuracy masks
  bool differential = false;
  std::uint8_t carrier_solution = 0;  ///< 0 none, 1 float, 2 fixed
  std::uint8_t satellites_used = 0;

  std::optional<double> latitude_rad, longitude_rad;
  std::optional<double> ellipsoidal_height_m, mean_sea_level_height_m;
  std::optional<double> horizontal_accuracy_m, vertical_accuracy_m;

  std::optional<double> velocity_north_mps, velocity_east_mps, velocity_down_mps;
  std::optional<double> ground_speed_mps, course_rad;
  std::optional<double> speed_accuracy_mps, course_accuracy_rad;

  std::optional<double> position_dop;
  std::optional<double> vehicle_heading_rad;
  std::optional<double> magnetic_declination_rad, magnetic_accuracy_rad;
};

enum class UbxGnss : std::uint8_t { gps, sbas, galileo, beidou, imes, qzss, glonass, navic };
std::string_view to_string(UbxGnss gnss);  ///< "unknown" for numbers outside of the list

struct UbxSatellite {
  UbxGnss gnss = UbxGnss::gps;
  std::uint8_t number = 0;                           ///< within its constellation
  std::optional<double> cno_dbhz;                    ///< empty: not tracked
  std::optional<double> elevation_rad, azimuth_rad;  ///< empty: unknown
  double residual_m = 0;                             ///< of the pseudorange
  std::uint8_t quality = 0;  ///< 0 no signal .. 4 code .. 7 code and carrier
  bool used = false;         ///< in the navigation solution
  std::optional<bool> healthy;
  std::uint8_t orbit_source = 0;  ///< 0 none, 1 ephemeris, 2 almanac, from 3 assistance
  bool has_ephemeris = false, has_almanac = false;
};

/// Satellites that the receiver knows.
struct NavSat {
  static constexpr std::string_view type = "NAV-SAT";
  static constexpr std::uint16_t class_and_id = 0x0135;
  NavSat() {}  // read in place, see message_list.hpp
  std::chrono::milliseconds itow{};
  boost::container::static_vector<UbxSatellite, 255> satellites;  ///< the wire's count is one byte
};

/// End of epoch: all navigation messages of this time of week have been sent.
struct NavEoe {
  static constexpr std::string_view type = "NAV-EOE";
  static constexpr std::uint16_t class_and_id = 0x0161;
  std::chrono::milliseconds itow{};
};

/// Each reads a payload into a fresh message. False if the message cannot have this length.
bool read(Bytes payload, NavPvt& m);  ///< 92 bytes, 84 from old receivers
bool read(Bytes payload, NavSat& m);
bool read(Bytes payload, NavEoe& m);

/// Returns the bytes of the whole frame, 0 if `out` is too small. NAV-PVT has its 92-byte form. The
/// wire cannot express "fix without velocity"; gnssFixOK is then cleared.
std::size_t encode(const NavPvt& m, std::span<std::uint8_t> out);
std::size_t encode(const NavSat& m, std::span<std::uint8_t> out);
std::size_t encode(const NavEoe& m, std::span<std::uint8_t> out);

template <class F>
void visit_fields(const NavPvt& m, F&& field) {
  field("itow_s", seconds(m.itow));
  visit_date(m.date, field);
  field("time_of_day_s", seconds(m.time_of_day));
  field("time_resolved", m.time_resolved);
  field("time_accuracy_s", m.time_accuracy_s);
  field("fix_type", static_cast<int>(m.fix_type));
  field("fix_ok", m.fix_ok);
  field("differential", m.differential);
  field("carrier_solution", m.carrier_solution);
  field("satellites_used", m.satellites_used);
  field("latitude_deg", degrees(m.latitude_rad));
  field("longitude_deg", degrees(m.longitude_rad));
  field("ellipsoidal_height_m", m.ellipsoidal_height_m);
  field("mean_sea_level_height_m", m.mean_sea_level_height_m);
  field("horizontal_accuracy_m", m.horizontal_accuracy_m);
  field("vertical_accuracy_m", m.vertical_accuracy_m);
  field("velocity_north_mps", m.velocity_north_mps);
  field("velocity_east_mps", m.velocity_east_mps);
  field("velocity_down_mps", m.velocity_down_mps);
  field("ground_speed_mps", m.ground_speed_mps);
  field("course_deg", degrees(m.course_rad));
  field("speed_accuracy_mps", m.speed_accuracy_mps);
  field("course_accuracy_deg", degrees(m.course_accuracy_rad));
  field("position_dop", m.position_dop);
  field("vehicle_heading_deg", degrees(m.vehicle_heading_rad));
  field("magnetic_declination_deg", degrees(m.magnetic_declination_rad));
  field("magnetic_accuracy_deg", degrees(m.magnetic_accuracy_rad));
}

template <class F>
void visit_fields(const UbxSatellite& m, F&& field) {
  field("gnss", to_string(m.gnss));
  field("number", m.number);
  field("cno_dbhz", m.cno_dbhz);
  field("elevation_deg", degrees(m.elevation_rad));
  field("azimuth_deg", degrees(m.azimuth_rad));
  field("residual_m", m.residual_m);
  field("quality", m.quality);
  field("used", m.used);
  field("healthy", m.healthy);
  field("orbit_source", m.orbit_source);
  field("has_ephemeris", m.has_ephemeris);
  field("has_almanac", m.has_almanac);
}

template <class F>
void visit_fields(const NavSat& m, F&& field) {
  field("itow_s", seconds(m.itow));
  field("satellites", std::span{m.satellites});
}

template <class F>
void visit_fields(const NavEoe& m, F&& field) {
  field("itow_s", seconds(m.itow));
}

}  // namespace drydock::wire
