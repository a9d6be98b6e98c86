#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "drivers/wire/fields.hpp"

/// Messages of an Xsens MTi on CAN that a bench needs. Layouts and steps: Xsens MT1604P revision A,
/// section 6. Big-endian. No raw value means "not available"; the status word reports errors.
namespace drydock::wire::xsens {

struct Error {
  static constexpr std::string_view type = "error";
  std::uint8_t code = 0;  ///< 1: the output buffer was full and a message was dropped
};

/// Ticks of 100 us of the device's clock. They wrap after 119.3 h. (The SDK's comment and one table
/// of MT1604P have microseconds; Movella's page of the CAN messages has 10 kHz.)
struct SampleTime {
  static constexpr std::string_view type = "sample_time";
  std::uint32_t ticks = 0;
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

using EulerAngles = Vector<EulerLayout>;
using RateOfTurn = Vector<RateLayout>;
using RateOfTurnHr = Vector<RateHrLayout>;
using Acceleration = Vector<AccelerationLayout>;  ///< specific force: includes gravity's reaction
using AccelerationHr = Vector<AccelerationHrLayout>;
using FreeAcceleration = Vector<FreeAccelerationLayout>;
using Velocity = Vector<VelocityLayout>;

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
