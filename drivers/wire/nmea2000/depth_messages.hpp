#pragma once

#include "drivers/wire/nmea2000/message_layout.hpp"

/// Pressure, temperature and the echo sounder. Layouts: canboat's public PGN database.
namespace drydock::wire::nmea2000 {

/// PGN 130314. A vehicle's own depth comes from the pressure of the water.
struct Pressure {
  static constexpr std::string_view type = "pressure";
  static constexpr std::uint32_t pgn = 130314;
  static constexpr std::uint8_t priority = 5;
  static constexpr std::size_t bytes = 8, least = 7;
  static constexpr std::uint8_t water = 1;  ///< value of `kind`
  std::uint8_t source = j1939::null_address;
  std::optional<std::uint8_t> sequence, instance;
  std::optional<std::uint8_t> kind;  ///< 0 atmospheric, 1 water, 2 steam, 3 compressed air, ...
  std::optional<double> pressure_pa;

  static void layout(auto& m, auto&& field) {
    field("sequence", m.sequence, Whole{0});
    field("instance", m.instance, Whole{1});
    field("kind", m.kind, Whole{2});
    field("pressure_pa", m.pressure_pa, Scaled<std::int32_t>{3, tenth});
  }
};

/// PGN 130312.
struct Temperature {
  static constexpr std::string_view type = "temperature";
  static constexpr std::uint32_t pgn = 130312;
  static constexpr std::uint8_t priority = 5;
  static constexpr std::size_t bytes = 8, least = 5;
  static constexpr std::uint8_t sea = 0;  ///< value of `kind`
  std::uint8_t source = j1939::null_address;
  std::optional<std::uint8_t> sequence, instance;
  std::optional<std::uint8_t> kind;  ///< 0 sea, 1 outside, 2 inside, 3 engine room, ...
  std::optional<double> actual_k, set_k;

  static void layout(auto& m, auto&& field) {
    field("sequence", m.sequence, Whole{0});
    field("instance", m.instance, Whole{1});
    field("kind", m.kind, Whole{2});
    field("actual_k", m.actual_k, Scaled<std::uint16_t>{3, hundredth});
    field("set_k", m.set_k, Scaled<std::uint16_t>{5, hundredth});
  }
};

/// PGN 128267: depth of water from an echo sounder.
struct WaterDepth {
  static constexpr std::string_view type = "water_depth";
  static constexpr std::uint32_t pgn = 128267;
  static constexpr std::uint8_t priority = 3;
  static constexpr std::size_t bytes = 8, least = 5;
  std::uint8_t source = j1939::null_address;
  std::optional<std::uint8_t> sequence;
  std::optional<double> depth_m;   ///< from the transducer down to the bed
  std::optional<double> offset_m;  ///< transducer to waterline (+) or keel (-)
  std::optional<double> maximum_range_m;

  static void layout(auto& m, auto&& field) {
    field("sequence", m.sequence, Whole{0});
    field("depth_m", m.depth_m, Scaled<std::uint32_t>{1, hundredth});
    field("offset_m", m.offset_m, Scaled<std::int16_t>{5, thousandth});
    field("maximum_range_m", m.maximum_range_m, Scaled<std::uint8_t>{7, {10, 1}});
  }
};

/// PGN 130310.
struct WaterAndAir {
  static constexpr std::string_view type = "water_and_air";
  static constexpr std::uint32_t pgn = 130310;
  static constexpr std::uint8_t priority = 5;
  static constexpr std::size_t bytes = 8, least = 3;
  std::uint8_t source = j1939::null_address;
  std::optional<std::uint8_t> sequence;
  std::optional<double> water_k, air_k, air_pressure_pa;

  static void layout(auto& m, auto&& field) {
    field("sequence", m.sequence, Whole{0});
    field("water_k", m.water_k, Scaled<std::uint16_t>{1, hundredth});
    field("air_k", m.air_k, Scaled<std::uint16_t>{3, hundredth});
    field("air_pressure_pa", m.air_pressure_pa, Scaled<std::uint16_t>{5, hundreds});
  }
};

/// PGN 130311.
struct Environment {
  static constexpr std::string_view type = "environment";
  static constexpr std::uint32_t pgn = 130311;
  static constexpr std::uint8_t priority = 5;
  static constexpr std::size_t bytes = 8, least = 4;
  std::uint8_t source = j1939::null_address;
  std::optional<std::uint8_t> sequence;
  std::optional<std::uint8_t> kind;           ///< of the temperature, as in `Temperature`
  std::optional<std::uint8_t> humidity_kind;  ///< 0 inside, 1 outside
  std::optional<double> temperature_k, humidity_percent, air_pressure_pa;

  static void layout(auto& m, auto&& field) {
    field("sequence", m.sequence, Whole{0});
    field("kind", m.kind, Bits{1, 0, 6});
    field("humidity_kind", m.humidity_kind, Bits{1, 6, 2});
    field("temperature_k", m.temperature_k, Scaled<std::uint16_t>{2, hundredth});
    field("humidity_percent", m.humidity_percent, Scaled<std::int16_t>{4, {4, 1000}});
    field("air_pressure_pa", m.air_pressure_pa, Scaled<std::uint16_t>{6, hundreds});
  }
};

}  // namespace drydock::wire::nmea2000
