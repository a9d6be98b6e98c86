#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "drivers/wire/fields.hpp"

/// Messages of an Xsens MTi on CAN. Layouts and steps: Xsens MT1604P revision A, section 6, and for
/// those that it does not describe the DBC of a public driver. Big-endian. No raw value means "not
/// available"; the status word reports errors.
namespace drydock::wire::xsens {

struct Error {
  static constexpr std::string_view type = "error";
  std::uint8_t code = 0;  ///< 1: the output buffer was full and a message was dropped
};

/// No list of the codes is public.
struct Warning {
  static constexpr std::string_view type = "warning";
  std::uint8_t code = 0;
};

/// Ticks of 100 us of the device's clock. They wrap after 119.3 h. (The SDK's comment and one table
/// of MT1604P have microseconds; Movella's page of the CAN messages has 10 kHz.)
struct SampleTime {
  static constexpr std::string_view type = "sample_time";
  std::uint32_t ticks = 0;
};

/// Before the device knows UTC, the time since it began, from a date of its own.
struct UtcTime {
  static constexpr std::string_view type = "utc_time";
  std::uint8_t year = 0;  ///< of the century; below 70: 20yy
  std::uint8_t month = 0, day = 0, hour = 0, minute = 0, second = 0;
  std::uint16_t ten_thousandths = 0;  ///< of a second
};

/// Numbers the samples; wraps at 16 bits.
struct GroupCounter {
  static constexpr std::string_view type = "group_counter";
  std::uint16_t counter = 0;
};

/// Bits of MT Low Level Communication, status word.
struct StatusWord {
  static constexpr std::string_view type = "status_word";
  std::uint32_t bits = 0;

  bool self_test_passed() const { return (bits & 1u) != 0; }
  bool acceleration_clipped() const { return (bits >> 8 & 7u) != 0; }
  bool rate_clipped() const { return (bits >> 11 & 7u) != 0; }
  bool filter_valid() const { return (bits >> 1 & 1u) != 0; }
  bool gnss_fix() const { return (bits >> 2 & 1u) != 0; }
  bool clock_synchronized() const { return (bits >> 6 & 1u) != 0; }
  bool magnetic_clipped() const { return (bits >> 14 & 7u) != 0; }
  unsigned filter_mode() const { return bits >> 23 & 7u; }
  unsigned rtk() const { return bits >> 27 & 3u; }  ///< 0 none, 1 float, 2 fixed
};

/// Rotates the sensor's axes to those of the configured local frame (by default east, north, up).
struct Quaternion {
  static constexpr std::string_view type = "quaternion";
  std::array<double, 4> wxyz{};
};

/// Rotation over one sample interval.
struct DeltaQ {
  static constexpr std::string_view type = "delta_q";
  std::array<double, 4> wxyz{};
};

/// Integral of the acceleration over one sample interval. The message contains its own step.
struct DeltaV {
  static constexpr std::string_view type = "delta_v";
  std::array<double, 3> velocity_mps{};
  std::uint8_t exponent = 0;  ///< the step is 2^-exponent m/s
};

/// Three int16 with one step. `Layout` gives type, keys, step and the unit in the keys.
template <class Layout>
struct Vector {
  static constexpr std::string_view type = Layout::type;
  std::array<double, 3> value{};  ///< SI units, radians
};

struct InRadians {
  static constexpr double shown = degrees(1.0);
};
struct InSi {
  static constexpr double shown = 1;
};

struct EulerLayout : InRadians {
  static constexpr std::string_view type = "euler_angles";
  static constexpr double step = radians(1.0 / 128);
  static constexpr std::array<std::string_view, 3> keys{"roll_deg", "pitch_deg", "yaw_deg"};
};
struct RateLayout : InRadians {
  static constexpr std::string_view type = "rate_of_turn";
  static constexpr double step = 1.0 / 512;
  static constexpr std::array<std::string_view, 3> keys{"rate_x_degps", "rate_y_degps",
                                                        "rate_z_degps"};
};
struct RateHrLayout : RateLayout {
  static constexpr std::string_view type = "rate_of_turn_hr";
};
struct AccelerationLayout : InSi {
  static constexpr std::string_view type = "acceleration";
  static constexpr double step = 1.0 / 256;
  static constexpr std::array<std::string_view, 3> keys{
      "acceleration_x_mps2", "acceleration_y_mps2", "acceleration_z_mps2"};
};
struct AccelerationHrLayout : AccelerationLayout {
  static constexpr std::string_view type = "acceleration_hr";
};
struct FreeAccelerationLayout : AccelerationLayout {
  static constexpr std::string_view type = "free_acceleration";  ///< without gravity, local frame
};
struct VelocityLayout : InSi {
  static constexpr std::string_view type = "velocity";  ///< in the local frame
  static constexpr double step = 1.0 / 64;
  static constexpr std::array<std::string_view, 3> keys{"velocity_x_mps", "velocity_y_mps",
                                                        "velocity_z_mps"};
};

struct MagneticLayout : InSi {
  static constexpr std::string_view type = "normed_magnetic_field";  ///< 1: as strong as at Xsens
  static constexpr double step = 1.0 / 1024;
  static constexpr std::array<std::string_view, 3> keys{"field_x", "field_y", "field_z"};
};

using EulerAngles = Vector<EulerLayout>;
using RateOfTurn = Vector<RateLayout>;
using RateOfTurnHr = Vector<RateHrLayout>;
using Acceleration = Vector<AccelerationLayout>;  ///< specific force: includes gravity's reaction
using AccelerationHr = Vector<AccelerationHrLayout>;
using FreeAcceleration = Vector<FreeAccelerationLayout>;
using Velocity = Vector<VelocityLayout>;
using MagneticField = Vector<MagneticLayout>;

/// One integer with a step and a zero. `Layout` gives type, key, integer, step and zero.
template <class Layout>
struct Scalar {
  static constexpr std::string_view type = Layout::type;
  double value = 0;  ///< SI units
};

struct TemperatureLayout {
  static constexpr std::string_view type = "imu_temperature", key = "temperature_k";
  using Raw = std::int16_t;
  static constexpr double step = 1.0 / 256, zero = zero_celsius_k;
};
struct PressureLayout {
  static constexpr std::string_view type = "barometric_pressure", key = "pressure_pa";
  using Raw = std::uint32_t;  ///< a public DBC calls it signed: then one atmosphere is negative
  static constexpr double step = 1.0 / 32768, zero = 0;
};
struct AltitudeLayout {
  static constexpr std::string_view type = "altitude_ellipsoid", key = "ellipsoid_height_m";
  using Raw = std::int32_t;
  static constexpr double step = 1.0 / 32768, zero = 0;
};
struct EcefLayout {
  using Raw = std::int32_t;
  static constexpr double step = 1.0 / 256, zero = 0;
};
struct EcefXLayout : EcefLayout {
  static constexpr std::string_view type = "ecef_x", key = "ecef_x_m";
};
struct EcefYLayout : EcefLayout {
  static constexpr std::string_view type = "ecef_y", key = "ecef_y_m";
};
struct EcefZLayout : EcefLayout {
  static constexpr std::string_view type = "ecef_z", key = "ecef_z_m";
};

using Temperature = Scalar<TemperatureLayout>;
using Pressure = Scalar<PressureLayout>;
using Altitude = Scalar<AltitudeLayout>;
using EcefX = Scalar<EcefXLayout>;
using EcefY = Scalar<EcefYLayout>;
using EcefZ = Scalar<EcefZLayout>;

/// Steps of 2^-24 and 2^-23 degrees: 7 and 13 mm.
struct LatitudeLongitude {
  static constexpr std::string_view type = "latitude_longitude";
  double latitude_rad = 0, longitude_rad = 0;
};

/// As the GNSS receiver inside says it. A fifth byte, of which two sources differ, is unread.
struct GnssStatus {
  static constexpr std::string_view type = "gnss_status";
  std::uint8_t fix_type = 0, satellites = 0, flags = 0, valid = 0;
};

struct GnssDop {
  static constexpr std::string_view type = "gnss_dop";
  std::array<double, 4> ptvh{};  ///< position, time, vertical, horizontal
};

template <class Layout, class Field>
void visit_fields(const Scalar<Layout>& m, Field&& field) {
  field(Layout::key, m.value);
}

template <class Field>
void visit_fields(const LatitudeLongitude& m, Field&& field) {
  field("latitude_deg", degrees(m.latitude_rad));
  field("longitude_deg", degrees(m.longitude_rad));
}

template <class Field>
void visit_fields(const GnssStatus& m, Field&& field) {
  field("fix_type", m.fix_type);
  field("satellites", m.satellites);
  field("flags", m.flags);
  field("valid", m.valid);
}

template <class Field>
void visit_fields(const GnssDop& m, Field&& field) {
  field("position_dop", m.ptvh[0]);
  field("time_dop", m.ptvh[1]);
  field("vertical_dop", m.ptvh[2]);
  field("horizontal_dop", m.ptvh[3]);
}

template <class Field>
void visit_fields(const Warning& m, Field&& field) {
  field("code", m.code);
}

template <class Field>
void visit_fields(const UtcTime& m, Field&& field) {
  field("year", m.year + (m.year < 70 ? 2000 : 1900));
  field("month", m.month);
  field("day", m.day);
  field("time_of_day_s", m.hour * 3600 + m.minute * 60 + m.second + m.ten_thousandths / 1e4);
}

template <class Layout, class Field>
void visit_fields(const Vector<Layout>& m, Field&& field) {
  for (std::size_t i = 0; i < 3; ++i) field(Layout::keys[i], m.value[i] * Layout::shown);
}

template <class Field>
void visit_fields(const Error& m, Field&& field) {
  field("code", m.code);
}

template <class Field>
void visit_fields(const SampleTime& m, Field&& field) {
  field("device_time_s", m.ticks / 1e4);
}

template <class Field>
void visit_fields(const GroupCounter& m, Field&& field) {
  field("counter", m.counter);
}

template <class Field>
void visit_fields(const StatusWord& m, Field&& field) {
  field("bits", m.bits);
  field("self_test_passed", m.self_test_passed());
  field("acceleration_clipped", m.acceleration_clipped());
  field("rate_clipped", m.rate_clipped());
  field("magnetic_clipped", m.magnetic_clipped());
  field("filter_valid", m.filter_valid());
  field("filter_mode", m.filter_mode());
  field("gnss_fix", m.gnss_fix());
  field("rtk", m.rtk());
  field("clock_synchronized", m.clock_synchronized());
}

template <class Field>
void visit_fields(const Quaternion& m, Field&& field) {
  field("wxyz", m.wxyz);
}

template <class Field>
void visit_fields(const DeltaQ& m, Field&& field) {
  field("wxyz", m.wxyz);
}

template <class Field>
void visit_fields(const DeltaV& m, Field&& field) {
  field("velocity_mps", m.velocity_mps);
  field("exponent", m.exponent);
}

}  // namespace drydock::wire::xsens
