#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <string_view>

#include "drivers/wire/mavlink/mavlink_messages.hpp"

/// What an autopilot says about the vehicle, as integers and floats of the wire. Times are since
/// its start, unless `_unix`. Source: common.xml of the MAVLink project.
namespace drydock::wire::mavlink {

using std::chrono::milliseconds;

struct SystemTime {
  static constexpr std::string_view type = "SYSTEM_TIME";
  static constexpr std::uint32_t id = 2;

  Sender sender;
  std::chrono::microseconds time_unix{};
  milliseconds time{};

  template <class M, class Visitor>
  static constexpr void lay_out(M& m, Visitor& field) {
    field("time_unix_usec", m.time_unix);
    field("time_boot_ms", m.time);
  }
};

struct GpsRawInt {
  static constexpr std::string_view type = "GPS_RAW_INT";
  static constexpr std::uint32_t id = 24;

  Sender sender;
  std::chrono::microseconds time{};
  std::int32_t latitude_e7 = 0, longitude_e7 = 0;  ///< degrees times 1e7
  std::int32_t height_mm = 0;                      ///< above mean sea level
  std::uint16_t hdop_e2 = 0, vdop_e2 = 0, speed_cmps = 0, course_cdeg = 0;  ///< 65535: not known
  std::uint8_t fix_type = 0, satellites = 0;
  std::int32_t ellipsoidal_height_mm = 0;
  std::uint32_t horizontal_accuracy_mm = 0, vertical_accuracy_mm = 0, speed_accuracy_mmps = 0;
  std::uint32_t heading_accuracy_e5 = 0;  ///< degrees times 1e5
  std::uint16_t yaw_cdeg = 0;             ///< 0: not known, 36000 is north

  template <class M, class Visitor>
  static constexpr void lay_out(M& m, Visitor& field) {
    field("time_usec", m.time);
    field("lat", m.latitude_e7);
    field("lon", m.longitude_e7);
    field("alt", m.height_mm);
    field("eph", m.hdop_e2);
    field("epv", m.vdop_e2);
    field("vel", m.speed_cmps);
    field("cog", m.course_cdeg);
    field("fix_type", m.fix_type);
    field("satellites_visible", m.satellites);
    field.extension("alt_ellipsoid", m.ellipsoidal_height_mm);
    field.extension("h_acc", m.horizontal_accuracy_mm);
    field.extension("v_acc", m.vertical_accuracy_mm);
    field.extension("vel_acc", m.speed_accuracy_mmps);
    field.extension("hdg_acc", m.heading_accuracy_e5);
    field.extension("yaw", m.yaw_cdeg);
  }
};

struct ScaledPressure {
  static constexpr std::string_view type = "SCALED_PRESSURE";
  static constexpr std::uint32_t id = 29;

  Sender sender;
  milliseconds time{};
  float absolute_hpa = 0, differential_hpa = 0;
  std::int16_t temperature_cdegc = 0, differential_temperature_cdegc = 0;

  template <class M, class Visitor>
  static constexpr void lay_out(M& m, Visitor& field) {
    field("time_boot_ms", m.time);
    field("press_abs", m.absolute_hpa);
    field("press_diff", m.differential_hpa);
    field("temperature", m.temperature_cdegc);
    field.extension("temperature_press_diff", m.differential_temperature_cdegc);
  }
};

struct Attitude {
  static constexpr std::string_view type = "ATTITUDE";
  static constexpr std::uint32_t id = 30;

  Sender sender;
  milliseconds time{};
  float roll_rad = 0, pitch_rad = 0, yaw_rad = 0;
  std::array<float, 3> rates_radps{};  ///< about x, y, z of the body FRD

  template <class M, class Visitor>
  static constexpr void lay_out(M& m, Visitor& field) {
    field("time_boot_ms", m.time);
    field("roll", m.roll_rad);
    field("pitch", m.pitch_rad);
    field("yaw", m.yaw_rad);
    field("rollspeed", m.rates_radps[0]);
    field("pitchspeed", m.rates_radps[1]);
    field("yawspeed", m.rates_radps[2]);
  }
};

struct LocalPositionNed {
  static constexpr std::string_view type = "LOCAL_POSITION_NED";
  static constexpr std::uint32_t id = 32;

  Sender sender;
  milliseconds time{};
  std::array<float, 3> position_m{}, velocity_mps{};  ///< north, east, down

  template <class M, class Visitor>
  static constexpr void lay_out(M& m, Visitor& field) {
    field("time_boot_ms", m.time);
    field("x", m.position_m[0]);
    field("y", m.position_m[1]);
    field("z", m.position_m[2]);
    field("vx", m.velocity_mps[0]);
    field("vy", m.velocity_mps[1]);
    field("vz", m.velocity_mps[2]);
  }
};

struct GlobalPositionInt {
  static constexpr std::string_view type = "GLOBAL_POSITION_INT";
  static constexpr std::uint32_t id = 33;

  Sender sender;
  milliseconds time{};
  std::int32_t latitude_e7 = 0, longitude_e7 = 0;
  std::int32_t height_mm = 0, height_above_home_mm = 0;
  std::int16_t north_cmps = 0, east_cmps = 0, down_cmps = 0;
  std::uint16_t heading_cdeg = 0;  ///< 65535: not known

  template <class M, class Visitor>
  static constexpr void lay_out(M& m, Visitor& field) {
    field("time_boot_ms", m.time);
    field("lat", m.latitude_e7);
    field("lon", m.longitude_e7);
    field("alt", m.height_mm);
    field("relative_alt", m.height_above_home_mm);
    field("vx", m.north_cmps);
    field("vy", m.east_cmps);
    field("vz", m.down_cmps);
    field("hdg", m.heading_cdeg);
  }
};

struct VfrHud {
  static constexpr std::string_view type = "VFR_HUD";
  static constexpr std::uint32_t id = 74;

  Sender sender;
  float fluid_speed_mps = 0, ground_speed_mps = 0, height_m = 0, climb_mps = 0;
  std::int16_t heading_deg = 0;
  std::uint16_t throttle_percent = 0;

  template <class M, class Visitor>
  static constexpr void lay_out(M& m, Visitor& field) {
    field("airspeed", m.fluid_speed_mps);
    field("groundspeed", m.ground_speed_mps);
    field("alt", m.height_m);
    field("climb", m.climb_mps);
    field("heading", m.heading_deg);
    field("throttle", m.throttle_percent);
  }
};

struct DistanceSensor {
  static constexpr std::string_view type = "DISTANCE_SENSOR";
  static constexpr std::uint32_t id = 132;

  Sender sender;
  milliseconds time{};
  std::uint16_t least_cm = 0, most_cm = 0, distance_cm = 0;
  std::uint8_t kind = 0, number = 0, orientation = 0;
  std::uint8_t variance_cm2 = 0;  ///< 255: not known
  float horizontal_view_rad = 0, vertical_view_rad = 0;
  std::array<float, 4> attitude{};  ///< quaternion w, x, y, z
  std::uint8_t quality_percent = 0;

  template <class M, class Visitor>
  static constexpr void lay_out(M& m, Visitor& field) {
    field("time_boot_ms", m.time);
    field("min_distance", m.least_cm);
    field("max_distance", m.most_cm);
    field("current_distance", m.distance_cm);
    field("type", m.kind);
    field("id", m.number);
    field("orientation", m.orientation);
    field("covariance", m.variance_cm2);
    field.extension("horizontal_fov", m.horizontal_view_rad);
    field.extension("vertical_fov", m.vertical_view_rad);
    field.extension("quaternion", m.attitude);
    field.extension("signal_quality", m.quality_percent);
  }
};

struct StatusText {
  static constexpr std::string_view type = "STATUSTEXT";
  static constexpr std::uint32_t id = 253;

  Sender sender;
  std::uint8_t severity = 0;    ///< as of syslog: 0 emergency to 7 debug
  std::array<char, 50> text{};  ///< ends at the first zero
  std::uint16_t text_id = 0;    ///< that all chunks of a long text share; 0: it has one
  std::uint8_t chunk = 0;

  template <class M, class Visitor>
  static constexpr void lay_out(M& m, Visitor& field) {
    field("severity", m.severity);
    field("text", m.text);
    field.extension("id", m.text_id);
    field.extension("chunk_seq", m.chunk);
  }
};

}  // namespace drydock::wire::mavlink
