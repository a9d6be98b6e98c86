#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <string_view>

/// Messages between sensors and an autopilot, in SI units and radians as they are sent; a value
/// that is not known is a NaN. Sources: the definitions minimal.xml, common.xml and
/// ardupilotmega.xml of the MAVLink project.
namespace drydock::wire::mavlink {

/// Who sent a message, and how many it sent before, modulo 256.
struct Sender {
  std::uint8_t system = 0, component = 0, sequence = 0;
  friend bool operator==(const Sender&, const Sender&) = default;
};

/// MAV_COMP_ID_VISUAL_INERTIAL_ODOMETRY.
constexpr std::uint8_t odometry_component = 197;

/// That a component is there and what it is; once a second.
struct Heartbeat {
  static constexpr std::string_view type = "HEARTBEAT";
  static constexpr std::uint32_t id = 0;
  static constexpr std::uint8_t onboard_controller = 18;  ///< MAV_TYPE
  static constexpr std::uint8_t no_autopilot = 8;         ///< MAV_AUTOPILOT_INVALID
  static constexpr std::uint8_t active = 4;               ///< MAV_STATE

  Sender sender;
  std::uint32_t custom_mode = 0;
  std::uint8_t vehicle = onboard_controller, autopilot = no_autopilot;
  std::uint8_t base_mode = 0, system_status = active, mavlink_version = 3;

  template <class M, class Visitor>
  static constexpr void lay_out(M& m, Visitor& field) {
    field("custom_mode", m.custom_mode);
    field("type", m.vehicle);
    field("autopilot", m.autopilot);
    field("base_mode", m.base_mode);
    field("system_status", m.system_status);
    field("mavlink_version", m.mavlink_version);
  }
};

/// A question for the time of another clock (`tc1` is 0), or the answer to it.
struct Timesync {
  static constexpr std::string_view type = "TIMESYNC";
  static constexpr std::uint32_t id = 111;

  Sender sender;
  std::chrono::nanoseconds tc1{};  ///< of who answers
  std::chrono::nanoseconds ts1{};  ///< of who asked, as the question had it
  std::uint8_t target_system = 0, target_component = 0;

  template <class M, class Visitor>
  static constexpr void lay_out(M& m, Visitor& field) {
    field("tc1", m.tc1);
    field("ts1", m.ts1);
    field.extension("target_system", m.target_system);
    field.extension("target_component", m.target_component);
  }
};

/// Position, attitude and velocity, each against a frame of its own.
struct Odometry {
  static constexpr std::string_view type = "ODOMETRY";
  static constexpr std::uint32_t id = 331;
  static constexpr std::uint8_t local_frd = 20, body_frd = 12;  ///< MAV_FRAME

  Sender sender;
  std::chrono::microseconds time{};         ///< since 1970, of validity
  std::array<float, 3> position_m{};        ///< in `frame`
  std::array<float, 4> attitude{};          ///< quaternion w, x, y, z: `child_frame` to `frame`
  std::array<float, 3> velocity_mps{};      ///< in `child_frame`
  std::array<float, 3> rates_radps{};       ///< about x, y, z of `child_frame`
  std::array<float, 21> pose_covariance{};  ///< upper right triangle of 6 x 6, row by row
  std::array<float, 21> velocity_covariance{};
  std::uint8_t frame = local_frd, child_frame = body_frd;
  std::uint8_t reset_counter = 0, estimator_type = 0;
  std::int8_t quality = 0;  ///< %, 1 to 100; 0: not known; -1: failed

  template <class M, class Visitor>
  static constexpr void lay_out(M& m, Visitor& field) {
    field("time_usec", m.time);
    field("x", m.position_m[0]);
    field("y", m.position_m[1]);
    field("z", m.position_m[2]);
    field("q", m.attitude);
    field("vx", m.velocity_mps[0]);
    field("vy", m.velocity_mps[1]);
    field("vz", m.velocity_mps[2]);
    field("rollspeed", m.rates_radps[0]);
    field("pitchspeed", m.rates_radps[1]);
    field("yawspeed", m.rates_radps[2]);
    field("pose_covariance", m.pose_covariance);
    field("velocity_covariance", m.velocity_covariance);
    field("frame_id", m.frame);
    field("child_frame_id", m.child_frame);
    field.extension("reset_counter", m.reset_counter);
    field.extension("estimator_type", m.estimator_type);
    field.extension("quality", m.quality);
  }
};

/// How far the body moved and turned since the message before.
struct VisionPositionDelta {
  static constexpr std::string_view type = "VISION_POSITION_DELTA";
  static constexpr std::uint32_t id = 11011;

  Sender sender;
  std::chrono::microseconds time{};        ///< since 1970, of the end of the interval
  std::chrono::microseconds time_delta{};  ///< length of the interval
  std::array<float, 3> angle_rad{};        ///< rotation vector, body FRD then to body FRD now
  std::array<float, 3> position_m{};       ///< in body FRD now
  float confidence = 0;                    ///< 0 to 100

  template <class M, class Visitor>
  static constexpr void lay_out(M& m, Visitor& field) {
    field("time_usec", m.time);
    field("time_delta_usec", m.time_delta);
    field("angle_delta", m.angle_rad);
    field("position_delta", m.position_m);
    field("confidence", m.confidence);
  }
};

}  // namespace drydock::wire::mavlink
