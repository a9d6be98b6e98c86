#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string_view>

#include "drivers/wire/ubx/ubx_nav.hpp"

/// The navigation solution in parts, from receivers before NAV-PVT (u-blox 5 to 7 interface
/// descriptions). The parts of an epoch have the same iTOW.
namespace drydock::wire {

using Ecef = std::array<std::optional<double>, 3>;  ///< x, y, z; all three or none

/// Fix type and solution in ECEF. It is the only part with the GPS week.
struct NavSol {
  static constexpr std::string_view type = "NAV-SOL";
  static constexpr std::uint16_t class_and_id = 0x0106;
  std::chrono::milliseconds itow{};
  std::chrono::nanoseconds itow_fraction{};  ///< signed, to be added to iTOW
  std::optional<int> gps_week;  ///< as the receiver counts it; old firmware wraps at 1024
  bool time_known = false;      ///< iTOW is GPS time, not time since power-up
  UbxFixType fix_type = UbxFixType::none;
  bool fix_ok = false;
  bool differential = false;
  Ecef position_ecef_m, velocity_ecef_mps;  ///< empty unless valid, as in NAV-PVT
  std::optional<double> position_accuracy_m, speed_accuracy_mps;
  std::optional<double> position_dop;
  std::uint8_t satellites_used = 0;
};

/// Fix type without a solution. Timing receivers send it instead of NAV-SOL.
struct NavStatus {
  static constexpr std::string_view type = "NAV-STATUS";
  static constexpr std::uint16_t class_and_id = 0x0103;
  std::chrono::milliseconds itow{};
  UbxFixType fix_type = UbxFixType::none;
  bool fix_ok = false;
  bool differential = false;
  bool week_known = false, time_known = false;
  double time_to_first_fix_s = 0;
  double uptime_s = 0;
};

/// It does not say whether there is a fix: NAV-SOL or NAV-STATUS of the same epoch does. A position
/// of unknown accuracy is empty.
struct NavPosllh {
  static constexpr std::string_view type = "NAV-POSLLH";
  static constexpr std::uint16_t class_and_id = 0x0102;
  std::chrono::milliseconds itow{};
  std::optional<double> latitude_rad, longitude_rad;
  std::optional<double> ellipsoidal_height_m, mean_sea_level_height_m;
  std::optional<double> horizontal_accuracy_m, vertical_accuracy_m;
};

/// The velocity, with the same rules as NAV-POSLLH.
struct NavVelned {
  static constexpr std::string_view type = "NAV-VELNED";
  static constexpr std::uint16_t class_and_id = 0x0112;
  std::chrono::milliseconds itow{};
  std::optional<double> velocity_north_mps, velocity_east_mps, velocity_down_mps;
  std::optional<double> speed_mps, ground_speed_mps, course_rad;
  std::optional<double> speed_accuracy_mps, course_accuracy_rad;
};

/// Dilutions of precision. It is the only part that has all of them.
struct NavDop {
  static constexpr std::string_view type = "NAV-DOP";
  static constexpr std::uint16_t class_and_id = 0x0104;
  std::chrono::milliseconds itow{};
  std::optional<double> geometric, position, time, vertical, horizontal, north, east;
};

bool read(Bytes payload, NavSol& m);
bool read(Bytes payload, NavStatus& m);
bool read(Bytes payload, NavPosllh& m);
bool read(Bytes payload, NavVelned& m);
bool read(Bytes payload, NavDop& m);

/// Returns the bytes of the whole frame, 0 if `out` is too small.
std::size_t encode(const NavSol& m, std::span<std::uint8_t> out);
std::size_t encode(const NavStatus& m, std::span<std::uint8_t> out);
std::size_t encode(const NavPosllh& m, std::span<std::uint8_t> out);
std::size_t encode(const NavVelned& m, std::span<std::uint8_t> out);
std::size_t encode(const NavDop& m, std::span<std::uint8_t> out);

template <class F>
void visit_fields(const NavSol& m, F&& field) {
  field("itow_s", seconds(m.itow));
  field("itow_fraction_s", seconds(m.itow_fraction));
  field("gps_week", m.gps_week);
  field("time_known", m.time_known);
  field("fix_type", static_cast<int>(m.fix_type));
  field("fix_ok", m.fix_ok);
  field("differential", m.differential);
  field("position_ecef_m", m.position_ecef_m);
  field("velocity_ecef_mps", m.velocity_ecef_mps);
  field("position_accuracy_m", m.position_accuracy_m);
  field("speed_accuracy_mps", m.speed_accuracy_mps);
  field("position_dop", m.position_dop);
  field("satellites_used", m.satellites_used);
}

template <class F>
void visit_fields(const NavStatus& m, F&& field) {
  field("itow_s", seconds(m.itow));
  field("fix_type", static_cast<int>(m.fix_type));
  field("fix_ok", m.fix_ok);
  field("differential", m.differential);
  field("week_known", m.week_known);
  field("time_known", m.time_known);
  field("time_to_first_fix_s", m.time_to_first_fix_s);
  field("uptime_s", m.uptime_s);
}

template <class F>
void visit_fields(const NavPosllh& m, F&& field) {
  field("itow_s", seconds(m.itow));
  field("latitude_deg", degrees(m.latitude_rad));
  field("longitude_deg", degrees(m.longitude_rad));
  field("ellipsoidal_height_m", m.ellipsoidal_height_m);
  field("mean_sea_level_height_m", m.mean_sea_level_height_m);
  field("horizontal_accuracy_m", m.horizontal_accuracy_m);
  field("vertical_accuracy_m", m.vertical_accuracy_m);
}

template <class F>
void visit_fields(const NavVelned& m, F&& field) {
  field("itow_s", seconds(m.itow));
  field("velocity_north_mps", m.velocity_north_mps);
  field("velocity_east_mps", m.velocity_east_mps);
  field("velocity_down_mps", m.velocity_down_mps);
  field("speed_mps", m.speed_mps);
  field("ground_speed_mps", m.ground_speed_mps);
  field("course_deg", degrees(m.course_rad));
  field("speed_accuracy_mps", m.speed_accuracy_mps);
  field("course_accuracy_deg", degrees(m.course_accuracy_rad));
}

template <class F>
void visit_fields(const NavDop& m, F&& field) {
  field("itow_s", seconds(m.itow));
  field("geometric_dop", m.geometric);
  field("position_dop", m.position);
  field("time_dop", m.time);
  field("vertical_dop", m.vertical);
  field("horizontal_dop", m.horizontal);
  field("north_dop", m.north);
  field("east_dop", m.east);
}

}  // namespace drydock::wire
