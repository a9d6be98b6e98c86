#pragma once

#include <boost/container/static_vector.hpp>
#include <numbers>
#include <span>

#include "drivers/measurement/units.hpp"
#include "drivers/wire/nmea2000/message_layout.hpp"

/// What a GNSS receiver says. Layouts: canboat's public PGN database.
namespace drydock::wire::nmea2000 {

constexpr double quarter_turn = std::numbers::pi / 2, half_turn = std::numbers::pi;
constexpr double rounding = 1e-12;  ///< of a degree's decimal, rad
template <class Raw>
constexpr Scaled<Raw> angle_within(double limit_rad, std::size_t at, double steps_per_degree) {
  return {at, {units::degree, steps_per_degree}, -limit_rad - rounding, limit_rad + rounding};
}

/// PGN 129025. A value beyond the poles or the date line is empty.
struct RapidPosition {
  static constexpr std::string_view type = "rapid_position";
  static constexpr std::uint32_t pgn = 129025;
  static constexpr std::uint8_t priority = 2;
  static constexpr std::size_t bytes = 8, least = 8;
  std::uint8_t source = j1939::null_address;
  std::optional<double> latitude_rad, longitude_rad;

  static void layout(auto& m, auto&& field) {
    field("latitude_rad", m.latitude_rad, angle_within<std::int32_t>(quarter_turn, 0, 1e7));
    field("longitude_rad", m.longitude_rad, angle_within<std::int32_t>(half_turn, 4, 1e7));
  }
};

/// PGN 129029, a fast packet: position fix. Receivers without a fix still send a position and
/// dilutions below zero; those are empty here.
struct GnssPosition {
  static constexpr std::string_view type = "gnss_position";
  static constexpr std::uint32_t pgn = 129029;
  static constexpr std::uint8_t priority = 3;
  static constexpr std::size_t bytes = 43, least = 43;  ///< without reference stations
  static constexpr std::uint8_t no_fix = 0;             ///< value of `method`
  std::uint8_t source = j1939::null_address;
  std::optional<std::uint8_t> sequence;
  std::optional<std::int64_t> utc_ns;  ///< since 1970
  std::optional<double> latitude_rad, longitude_rad;
  std::optional<double> altitude_m;            ///< above the WGS-84 ellipsoid
  std::optional<std::uint8_t> system, method;  ///< method 0 no fix, 1 GNSS, 2 DGNSS, 3 precise, ...
  std::optional<std::uint8_t> satellites;
  std::optional<double> horizontal_dop, position_dop;
  std::optional<double> geoid_height_m;
  std::optional<std::uint8_t> integrity;           ///< 0 not checked, 1 safe, 2 caution
  std::optional<std::uint8_t> reference_stations;  ///< the first of them follows; we send none
  std::optional<std::uint8_t> station_system;
  std::optional<std::uint16_t> station_id;
  std::optional<double> station_age_s;  ///< of its corrections

  static void layout(auto& m, auto&& field) {
    field("sequence", m.sequence, Whole{0});
    field("utc_ns", m.utc_ns, DayTime{1});
    field("latitude_rad", m.latitude_rad, angle_within<std::int64_t>(quarter_turn, 7, 1e16));
    field("longitude_rad", m.longitude_rad, angle_within<std::int64_t>(half_turn, 15, 1e16));
    field("altitude_m", m.altitude_m, Scaled<std::int64_t>{23, {1, 1'000'000}});
    field("system", m.system, Bits{31, 0, 4});
    field("method", m.method, Bits{31, 4, 4});
    field("satellites", m.satellites, Whole{33});
    field("horizontal_dop", m.horizontal_dop, Scaled<std::int16_t>{34, hundredth, 0});
    field("position_dop", m.position_dop, Scaled<std::int16_t>{36, hundredth, 0});
    field("geoid_height_m", m.geoid_height_m, Scaled<std::int32_t>{38, hundredth});
    field("integrity", m.integrity, Bits{32, 0, 2});
    field("reference_stations", m.reference_stations, Whole{42});
    field("station_system", m.station_system, Bits{43, 0, 4});
    field("station_id", m.station_id, WordBits{43, 4, 12});
    field("station_age_s", m.station_age_s, Scaled<std::uint16_t>{45, hundredth});
  }
  void correct() {
    if (method.value_or(no_fix) == no_fix) latitude_rad = longitude_rad = altitude_m = std::nullopt;
  }
};

/// PGN 129026: course and speed over ground.
struct CourseAndSpeed {
  static constexpr std::string_view type = "course_and_speed";
  static constexpr std::uint32_t pgn = 129026;
  static constexpr std::uint8_t priority = 2;
  static constexpr std::size_t bytes = 8, least = 4;
  std::uint8_t source = j1939::null_address;
  std::optional<std::uint8_t> sequence;
  std::optional<std::uint8_t> reference;  ///< of the course: 0 true, 1 magnetic
  std::optional<double> course_rad, speed_mps;

  static void layout(auto& m, auto&& field) {
    field("sequence", m.sequence, Whole{0});
    field("reference", m.reference, Bits{1, 0, 2});
    field("course_rad", m.course_rad, Scaled<std::uint16_t>{2, angle_step});
    field("speed_mps", m.speed_mps, Scaled<std::uint16_t>{4, hundredth});
  }
};

/// PGN 129539: dilutions of precision. A negative one is empty.
struct Dilutions {
  static constexpr std::string_view type = "dilutions";
  static constexpr std::uint32_t pgn = 129539;
  static constexpr std::uint8_t priority = 6;
  static constexpr std::size_t bytes = 8, least = 4;
  std::uint8_t source = j1939::null_address;
  std::optional<std::uint8_t> sequence;
  std::optional<std::uint8_t> desired_mode, actual_mode;  ///< 0 1D, 1 2D, 2 3D, 3 automatic
  std::optional<double> horizontal_dop, vertical_dop, time_dop;

  static void layout(auto& m, auto&& field) {
    using Dilution = Scaled<std::int16_t>;
    field("sequence", m.sequence, Whole{0});
    field("desired_mode", m.desired_mode, Bits{1, 0, 3});
    field("actual_mode", m.actual_mode, Bits{1, 3, 3});
    field("horizontal_dop", m.horizontal_dop, Dilution{2, hundredth, 0});
    field("vertical_dop", m.vertical_dop, Dilution{4, hundredth, 0});
    field("time_dop", m.time_dop, Dilution{6, hundredth, 0});
  }
};

/// `status`: 0 not tracked, 1 tracked, 2 used, 3 to 5 the same with a differential correction.
struct SatelliteInView {
  static constexpr std::size_t bytes = 12;
  std::optional<std::uint8_t> number;  ///< GPS 1 to 32, SBAS 33 to 64, GLONASS 65 to 96
  std::optional<double> elevation_rad, azimuth_rad, snr_db, residual_m;
  std::optional<std::uint8_t> status;
  std::optional<std::uint8_t> system;  ///< later edition; empty from older receivers

  static void layout(auto& m, auto&& field) {
    field("number", m.number, Whole{0});
    field("elevation_rad", m.elevation_rad, Scaled<std::int16_t>{1, angle_step});
    field("azimuth_rad", m.azimuth_rad, Scaled<std::uint16_t>{3, angle_step});
    field("snr_db", m.snr_db, Scaled<std::int16_t>{5, hundredth});
    field("residual_m", m.residual_m, Scaled<std::int32_t>{7, {1, 100'000}});
    field("status", m.status, Bits{11, 0, 4});
    field("system", m.system, Bits{11, 4, 4});
  }
};

/// PGN 129540, a fast packet: 3 bytes and 12 for each satellite.
struct SatellitesInView {
  static constexpr std::string_view type = "satellites_in_view";
  static constexpr std::uint32_t pgn = 129540;
  static constexpr std::uint8_t priority = 6;
  static constexpr std::size_t head = 3, most = 18;
  static constexpr std::size_t longest = head + most * SatelliteInView::bytes;
  std::uint8_t source = j1939::null_address;
  std::optional<std::uint8_t> sequence;
  std::optional<std::uint8_t> residual_mode;  ///< 0 before the position, 1 after it
  std::optional<std::uint8_t> in_view;        ///< as the receiver counts them
  boost::container::static_vector<SatelliteInView, most> satellites;

  static void layout(auto& m, auto&& field) {
    field("sequence", m.sequence, Whole{0});
    field("residual_mode", m.residual_mode, Bits{1, 0, 2});
    field("in_view", m.in_view, Whole{2});
  }
};

/// As many satellites as the message holds and counts, the last as far as it goes. Empty without a
/// count, and if it counts more than a fast packet can hold.
std::optional<SatellitesInView> decode_satellites_in_view(std::uint8_t source, Bytes message);

/// Bytes of the message, which are written to `out`.
std::size_t encode(const SatellitesInView& message,
                   std::span<std::uint8_t, SatellitesInView::longest> out);

template <class Field>
void visit_fields(const SatelliteInView& m, Field&& field) {
  SatelliteInView::layout(
      m, [&](std::string_view key, const auto& value, const auto&) { field(key, value); });
}

template <class Field>
void visit_fields(const SatellitesInView& m, Field&& field) {
  field("source", m.source);
  SatellitesInView::layout(
      m, [&](std::string_view key, const auto& value, const auto&) { field(key, value); });
  field("satellites", std::span{m.satellites});
}

}  // namespace drydock::wire::nmea2000
