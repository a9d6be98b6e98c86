#pragma once

#include "drivers/wire/nmea2000/message_layout.hpp"

/// Speed log, distance log and the time of the bus. Layouts: canboat's public PGN
/// database.
namespace drydock::wire::nmea2000 {

/// PGN 128259. The speeds have no sign, and there is none across the vessel.
struct Speed {
  static constexpr std::string_view type = "speed";
  static constexpr std::uint32_t pgn = 128259;
  static constexpr std::uint8_t priority = 2;
  static constexpr std::size_t bytes = 8, least = 3;
  static constexpr std::uint8_t electromagnetic = 4;       ///< value of `sensor`
  static constexpr std::uint8_t forward = 0, reverse = 1;  ///< values of `direction`
  std::uint8_t source = j1939::null_address;
  std::optional<std::uint8_t> sequence;
  std::optional<double> water_mps, ground_mps;
  std::optional<std::uint8_t> sensor;  ///< 0 paddle wheel, 1 pitot, 2 Doppler, 3 correlation, 4 EM
  std::optional<std::uint8_t> direction;  ///< 0 forward, 1 reverse, or of another maker's own

  static void layout(auto& m, auto&& field) {
    field("sequence", m.sequence, Whole{0});
    field("water_mps", m.water_mps, Scaled<std::uint16_t>{1, hundredth});
    field("ground_mps", m.ground_mps, Scaled<std::uint16_t>{3, hundredth});
    field("sensor", m.sensor, Whole{5});
    field("direction", m.direction, Bits{6, 0, 4});
  }
};

/// PGN 128275, a fast packet: distance through the water.
struct DistanceLog {
  static constexpr std::string_view type = "distance_log";
  static constexpr std::uint32_t pgn = 128275;
  static constexpr std::uint8_t priority = 6;
  static constexpr std::size_t bytes = 14, least = 10;
  std::uint8_t source = j1939::null_address;
  std::optional<std::int64_t> utc_ns;  ///< since 1970
  std::optional<double> total_m;       ///< since the log was installed
  std::optional<double> trip_m;        ///< since it was last reset

  static void layout(auto& m, auto&& field) {
    field("utc_ns", m.utc_ns, DayTime{0});
    field("total_m", m.total_m, Scaled<std::uint32_t>{6, ones});
    field("trip_m", m.trip_m, Scaled<std::uint32_t>{10, ones});
  }
};

/// PGN 126992.
struct SystemTime {
  static constexpr std::string_view type = "system_time";
  static constexpr std::uint32_t pgn = 126992;
  static constexpr std::uint8_t priority = 3;
  static constexpr std::size_t bytes = 8, least = 8;
  std::uint8_t source = j1939::null_address;
  std::optional<std::uint8_t> sequence;
  std::optional<std::uint8_t>
      clock;  ///< 0 GPS, 1 GLONASS, 2 radio, 3 caesium, 4 rubidium, 5 crystal
  std::optional<std::int64_t> utc_ns;  ///< since 1970

  static void layout(auto& m, auto&& field) {
    field("sequence", m.sequence, Whole{0});
    field("clock", m.clock, Bits{1, 0, 4});
    field("utc_ns", m.utc_ns, DayTime{2});
  }
};

}  // namespace drydock::wire::nmea2000
