#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

#include "drivers/wire/can/can_frame.hpp"
#include "drivers/wire/can/sbg_names.hpp"
#include "drivers/wire/codec.hpp"
#include "drivers/wire/fields.hpp"

/// SBG Systems inertial sensors on CAN (sbgECom): the groups of the IMU and of the navigation
/// filter. Layouts and steps: SBG's sbgECom repository, doc/canProtocol.md and can/sbgCan.dbc.
/// Identifiers are as delivered, with 11 bits. Little-endian; no checksum, no counter. The time of
/// a group comes first.
namespace drydock::wire::sbg {

/// Microseconds since power-up of the device. They wrap after 71.6 min.
struct ImuInfo {
  static constexpr std::string_view type = "imu_info";
  static constexpr std::uint32_t id = 0x120;
  static constexpr std::uint8_t size = 8;
  std::uint32_t time_us = 0;
  std::uint16_t status = 0;
  double temperature_k = zero_celsius_k;
};

struct EkfInfo {
  static constexpr std::string_view type = "ekf_info";
  static constexpr std::uint32_t id = 0x130;
  static constexpr std::uint8_t size = 4;
  std::uint32_t time_us = 0;
};

/// Several int16 with one step. `Layout` gives type, identifier, keys, step and the unit in the
/// keys.
template <class Layout>
struct Axes {
  static constexpr std::string_view type = Layout::type;
  static constexpr std::uint32_t id = Layout::id;
  static constexpr std::uint8_t size = 2 * Layout::keys.size();
  std::array<double, Layout::keys.size()> value{};  ///< SI units, radians
};

struct AccelerationLayout {
  static constexpr std::string_view type = "imu_acceleration";
  static constexpr std::uint32_t id = 0x121;
  static constexpr double step = 0.01, shown = 1;
  static constexpr std::array<std::string_view, 3> keys{
      "acceleration_x_mps2", "acceleration_y_mps2", "acceleration_z_mps2"};
};
struct RateLayout {
  static constexpr std::string_view type = "imu_rate";
  static constexpr std::uint32_t id = 0x122;
  static constexpr double step = 0.001, shown = degrees(1.0);
  static constexpr std::array<std::string_view, 3> keys{"rate_x_degps", "rate_y_degps",
                                                        "rate_z_degps"};
};
struct QuaternionLayout {
  static constexpr std::string_view type = "ekf_quaternion";
  static constexpr std::uint32_t id = 0x131;
  static constexpr double step = 1.0 / 32767, shown = 1;
  static constexpr std::array<std::string_view, 4> keys{"w", "x", "y", "z"};
};
struct EulerLayout {
  static constexpr std::string_view type = "ekf_euler";
  static constexpr std::uint32_t id = 0x132;
  static constexpr double step = 1e-4, shown = degrees(1.0);
  static constexpr std::array<std::string_view, 3> keys{"roll_deg", "pitch_deg", "yaw_deg"};
};
struct VelocityLayout {
  static constexpr std::string_view type = "ekf_velocity";
  static constexpr std::uint32_t id = 0x137;
  static constexpr double step = 0.01, shown = 1;
  static constexpr std::array<std::string_view, 3> keys{"north_mps", "east_mps", "down_mps"};
};
struct BodyVelocityLayout {
  static constexpr std::string_view type = "ekf_body_velocity";
  static constexpr std::uint32_t id = 0x139;
  static constexpr double step = 0.01, shown = 1;
  static constexpr std::array<std::string_view, 3> keys{"forward_mps", "starboard_mps", "down_mps"};
};

using ImuAcceleration = Axes<AccelerationLayout>;  ///< gravity included
using ImuRate = Axes<RateLayout>;
using EkfQuaternion = Axes<QuaternionLayout>;
using EkfEuler = Axes<EulerLayout>;
using EkfVelocity = Axes<VelocityLayout>;
using EkfBodyVelocity = Axes<BodyVelocityLayout>;

struct EkfPosition {
  static constexpr std::string_view type = "ekf_position";
  static constexpr std::uint32_t id = 0x134;
  static constexpr std::uint8_t size = 8;
  double latitude_rad = 0, longitude_rad = 0;
};

struct EkfAltitude {
  static constexpr std::string_view type = "ekf_altitude";
  static constexpr std::uint32_t id = 0x135;
  static constexpr std::uint8_t size = 6;
  double mean_sea_level_height_m = 0, geoid_separation_m = 0;
};

using Message = std::variant<ImuInfo, ImuAcceleration, ImuRate, EkfInfo, EkfQuaternion, EkfEuler,
                             EkfPosition, EkfAltitude, EkfVelocity, EkfBodyVelocity>;

CanFrame encode(const Message& message);

/// True for a data frame with one of the identifiers that these devices have when delivered.
bool is_ours(const CanFrame& frame);

template <class Field>
void visit_fields(const ImuInfo& m, Field&& field) {
  field("device_time_s", m.time_us / 1e6);
  field("status", m.status);
  field("temperature_k", m.temperature_k);
}

template <class Field>
void visit_fields(const EkfInfo& m, Field&& field) {
  field("device_time_s", m.time_us / 1e6);
}

template <class Layout, class Field>
void visit_fields(const Axes<Layout>& m, Field&& field) {
  for (std::size_t i = 0; i < m.value.size(); ++i)
    field(Layout::keys[i], m.value[i] * Layout::shown);
}

template <class Field>
void visit_fields(const EkfPosition& m, Field&& field) {
  field("latitude_deg", degrees(m.latitude_rad));
  field("longitude_deg", degrees(m.longitude_rad));
}

template <class Field>
void visit_fields(const EkfAltitude& m, Field&& field) {
  field("mean_sea_level_height_m", m.mean_sea_level_height_m);
  field("geoid_separation_m", m.geoid_separation_m);
}

}  // namespace drydock::wire::sbg

namespace drydock::wire {

struct Sbg {
  static constexpr std::string_view name = "sbg";
  using Message = sbg::Message;

  /// It ignores bytes behind a message's length.
  class Decoder {
   public:
    std::optional<Message> receive(const CanFrame& frame);
    const StreamCounters& counters() const { return counters_; }
    /// Of frames that it does not read.
    static std::string_view frame_name(const CanFrame& frame) {
      return frame.extended ? std::string_view() : sbg::message_name(frame.id);
    }

   private:
    StreamCounters counters_;
  };
};

}  // namespace drydock::wire
