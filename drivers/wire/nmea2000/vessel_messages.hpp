#pragma once

#include "drivers/wire/nmea2000/message_layout.hpp"

/// How the vessel points and turns. Layouts: canboat's public PGN database. Angles are NMEA 2000's
/// own: headings clockwise from north, pitch positive bow up, roll positive starboard down.
namespace drydock::wire::nmea2000 {

constexpr Resolution turn_step{1, 32'000'000};              ///< rad/s
constexpr double half_turn_rad = 3.1416;                    ///< pi in steps of an angle
constexpr std::uint8_t true_north = 0, magnetic_north = 1;  ///< values of a `reference`

/// PGN 127250. True heading = magnetic heading + deviation + variation, each positive to the east.
struct VesselHeading {
  static constexpr std::string_view type = "vessel_heading";
  static constexpr std::uint32_t pgn = 127250;
  static constexpr std::uint8_t priority = 2;
  static constexpr std::size_t bytes = 8, least = 3;
  std::uint8_t source = j1939::null_address;
  std::optional<std::uint8_t> sequence;
  std::optional<double> heading_rad, deviation_rad, variation_rad;
  std::optional<std::uint8_t> reference;  ///< of the heading: true_north or magnetic_north

  static void layout(auto& m, auto&& field) {
    field("sequence", m.sequence, Whole{0});
    field("heading_rad", m.heading_rad, Scaled<std::uint16_t>{1, angle_step});
    field("deviation_rad", m.deviation_rad, Scaled<std::int16_t>{3, angle_step});
    field("variation_rad", m.variation_rad, Scaled<std::int16_t>{5, angle_step});
    field("reference", m.reference, Bits{7, 0, 2});
  }
};

/// PGN 127251: positive to starboard.
struct RateOfTurn {
  static constexpr std::string_view type = "turn_rate";
  static constexpr std::uint32_t pgn = 127251;
  static constexpr std::uint8_t priority = 2;
  static constexpr std::size_t bytes = 8, least = 5;
  std::uint8_t source = j1939::null_address;
  std::optional<std::uint8_t> sequence;
  std::optional<double> rate_radps;

  static void layout(auto& m, auto&& field) {
    field("sequence", m.sequence, Whole{0});
    field("rate_radps", m.rate_radps, Scaled<std::int32_t>{1, turn_step});
  }
};

/// PGN 127252. A later edition puts a delay into the reserved bytes; older devices leave anything
/// there, so nobody can tell the two apart and the delay is not read.
struct Heave {
  static constexpr std::string_view type = "heave";
  static constexpr std::uint32_t pgn = 127252;
  static constexpr std::uint8_t priority = 3;
  static constexpr std::size_t bytes = 8, least = 3;
  std::uint8_t source = j1939::null_address;
  std::optional<std::uint8_t> sequence;
  std::optional<double> heave_m;  ///< most devices: positive up

  static void layout(auto& m, auto&& field) {
    field("sequence", m.sequence, Whole{0});
    field("heave_m", m.heave_m, Scaled<std::int16_t>{1, hundredth});
  }
};

/// PGN 127257. Most devices leave the yaw out and send PGN 127250 beside it.
struct Attitude {
  static constexpr std::string_view type = "attitude";
  static constexpr std::uint32_t pgn = 127257;
  static constexpr std::uint8_t priority = 3;
  static constexpr std::size_t bytes = 8, least = 3;
  std::uint8_t source = j1939::null_address;
  std::optional<std::uint8_t> sequence;
  std::optional<double> yaw_rad, pitch_rad, roll_rad;

  static void layout(auto& m, auto&& field) {
    field("sequence", m.sequence, Whole{0});
    // The driver judges pitch and roll, and tells what it refuses.
    field("yaw_rad", m.yaw_rad, Scaled<std::int16_t>{1, angle_step, -half_turn_rad});
    field("pitch_rad", m.pitch_rad, Scaled<std::int16_t>{3, angle_step});
    field("roll_rad", m.roll_rad, Scaled<std::int16_t>{5, angle_step});
  }
};

/// PGN 127258: magnetic variation where the vessel is, positive to the east.
struct MagneticVariation {
  static constexpr std::string_view type = "magnetic_variation";
  static constexpr std::uint32_t pgn = 127258;
  static constexpr std::uint8_t priority = 6;
  static constexpr std::size_t bytes = 8, least = 6;
  std::uint8_t source = j1939::null_address;
  std::optional<std::uint8_t> sequence;
  std::optional<std::uint8_t> model;  ///< 0 manual, 1 chart, 2 table, 3 calculated, 4 WMM2000, ...
  std::optional<std::uint16_t> date_days;  ///< of the model's value, since 1970
  std::optional<double> variation_rad;

  static void layout(auto& m, auto&& field) {
    field("sequence", m.sequence, Whole{0});
    field("model", m.model, Bits{1, 0, 4});
    field("date_days", m.date_days, Whole{2});
    field("variation_rad", m.variation_rad, Scaled<std::int16_t>{4, angle_step});
  }
};

}  // namespace drydock::wire::nmea2000
