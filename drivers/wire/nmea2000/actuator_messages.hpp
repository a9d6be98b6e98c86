#pragma once

#include <numbers>

#include "drivers/wire/nmea2000/message_layout.hpp"

/// Rudders and engines. Layouts: canboat's public PGN database.
namespace drydock::wire::nmea2000 {

/// PGN 127245.
struct Rudder {
  static constexpr std::string_view type = "rudder";
  static constexpr std::uint32_t pgn = 127245;
  static constexpr std::uint8_t priority = 2;
  static constexpr std::size_t bytes = 8, least = 6;
  std::uint8_t source = j1939::null_address;
  std::optional<std::uint8_t> instance;
  std::optional<std::uint8_t> direction_order;  ///< 0 none, 1 to starboard, 2 to port
  std::optional<double> angle_order_rad;
  std::optional<double> position_rad;  ///< positive turns the vehicle to starboard

  static void layout(auto& m, auto&& field) {
    field("instance", m.instance, Whole{0});
    field("direction_order", m.direction_order, Bits{1, 0, 3});
    field("angle_order_rad", m.angle_order_rad, Scaled<std::int16_t>{2, angle_step});
    field("position_rad", m.position_rad, Scaled<std::int16_t>{4, angle_step});
  }
};

/// PGN 127488, rapid update. Here the engine is the propeller shaft.
struct Engine {
  static constexpr std::string_view type = "engine";
  static constexpr std::uint32_t pgn = 127488;
  static constexpr std::uint8_t priority = 2;
  static constexpr std::size_t bytes = 8, least = 3;
  static constexpr Resolution quarter_turn_per_minute{std::numbers::pi, 120};  ///< rad/s
  std::uint8_t source = j1939::null_address;
  std::optional<std::uint8_t> instance;
  std::optional<double> speed_radps;
  std::optional<double> boost_pressure_pa;
  std::optional<double> tilt_percent;

  static void layout(auto& m, auto&& field) {
    field("instance", m.instance, Whole{0});
    field("speed_radps", m.speed_radps, Scaled<std::uint16_t>{1, quarter_turn_per_minute});
    field("boost_pressure_pa", m.boost_pressure_pa, Scaled<std::uint16_t>{3, hundreds});
    field("tilt_percent", m.tilt_percent, Scaled<std::int8_t>{5, ones});
  }
};

/// PGN 127237, a fast packet: what an autopilot wants and does.
struct HeadingControl {
  static constexpr std::string_view type = "heading_control";
  static constexpr std::uint32_t pgn = 127237;
  static constexpr std::uint8_t priority = 2;
  static constexpr std::size_t bytes = 21, least = 2;
  std::uint8_t source = j1939::null_address;
  /// 1: the limit is exceeded, or a hand on the helm overrides the autopilot.
  std::optional<std::uint8_t> rudder_limit_exceeded, off_heading_limit_exceeded;
  std::optional<std::uint8_t> off_track_limit_exceeded, override_active;
  std::optional<std::uint8_t> steering_mode, turn_mode;
  std::optional<std::uint8_t> reference;                   ///< of the headings: 0 true, 1 magnetic
  std::optional<std::uint8_t> commanded_rudder_direction;  ///< 0 none, 1 to starboard, 2 to port
  std::optional<double> commanded_rudder_rad, heading_to_steer_rad, track_rad, rudder_limit_rad;
  std::optional<double> off_heading_limit_rad, turn_radius_m, commanded_rate_radps;
  std::optional<double> off_track_limit_m, heading_rad;

  static void layout(auto& m, auto&& field) {
    using Signed = Scaled<std::int16_t>;
    using Unsigned = Scaled<std::uint16_t>;
    field("rudder_limit_exceeded", m.rudder_limit_exceeded, Bits{0, 0, 2});
    field("off_heading_limit_exceeded", m.off_heading_limit_exceeded, Bits{0, 2, 2});
    field("off_track_limit_exceeded", m.off_track_limit_exceeded, Bits{0, 4, 2});
    field("override_active", m.override_active, Bits{0, 6, 2});
    field("steering_mode", m.steering_mode, Bits{1, 0, 3});
    field("turn_mode", m.turn_mode, Bits{1, 3, 3});
    field("reference", m.reference, Bits{1, 6, 2});
    field("commanded_rudder_direction", m.commanded_rudder_direction, Bits{2, 5, 3});
    field("commanded_rudder_rad", m.commanded_rudder_rad, Signed{3, angle_step});
    field("heading_to_steer_rad", m.heading_to_steer_rad, Unsigned{5, angle_step});
    field("track_rad", m.track_rad, Unsigned{7, angle_step});
    field("rudder_limit_rad", m.rudder_limit_rad, Unsigned{9, angle_step});
    field("off_heading_limit_rad", m.off_heading_limit_rad, Unsigned{11, angle_step});
    field("turn_radius_m", m.turn_radius_m, Signed{13, ones});
    field("commanded_rate_radps", m.commanded_rate_radps, Signed{15, {1, 32'000}});
    field("off_track_limit_m", m.off_track_limit_m, Signed{17, ones});
    field("heading_rad", m.heading_rad, Unsigned{19, angle_step});
  }
};

}  // namespace drydock::wire::nmea2000
