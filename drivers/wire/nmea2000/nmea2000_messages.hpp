#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "drivers/wire/can/can_frame.hpp"
#include "drivers/wire/codec.hpp"
#include "drivers/wire/j1939/j1939.hpp"

/// Messages of NMEA 2000 on the bus of an underwater vehicle. Layouts: canboat's public PGN
/// database. A field that is "not available", "out of range" or "reserved" is an empty optional.
namespace drydock::wire::nmea2000 {

constexpr std::uint32_t rudder_pgn = 127245;
constexpr std::uint32_t engine_pgn = 127488;
constexpr std::uint32_t water_depth_pgn = 128267;
constexpr std::uint32_t gnss_position_pgn = 129029;
constexpr std::uint32_t temperature_pgn = 130312;
constexpr std::uint32_t pressure_pgn = 130314;

/// `sequence` (SID) is equal for all values that a device measured at one instant.
struct Pressure {
  static constexpr std::string_view type = "pressure";
  static constexpr std::uint8_t water = 1;  ///< value of `kind`
  std::uint8_t source = j1939::null_address;
  std::optional<std::uint8_t> sequence, instance;
  std::optional<std::uint8_t> kind;  ///< 0 atmospheric, 1 water, 2 steam, 3 compressed air, ...
  std::optional<double> pressure_pa;
};

struct Temperature {
  static constexpr std::string_view type = "temperature";
  static constexpr std::uint8_t sea = 0;  ///< value of `kind`
  std::uint8_t source = j1939::null_address;
  std::optional<std::uint8_t> sequence, instance;
  std::optional<std::uint8_t> kind;  ///< 0 sea, 1 outside, 2 inside, 3 engine room, ...
  std::optional<double> actual_k, set_k;
};

/// Depth of water from an echo sounder. A vehicle's own depth comes from `Pressure`.
struct WaterDepth {
  static constexpr std::string_view type = "water_depth";
  std::uint8_t source = j1939::null_address;
  std::optional<std::uint8_t> sequence;
  std::optional<double> depth_m;   ///< from the transducer down to the bed
  std::optional<double> offset_m;  ///< transducer to waterline (+) or keel (-)
  std::optional<double> maximum_range_m;
};

struct Rudder {
  static constexpr std::string_view type = "rudder";
  std::uint8_t source = j1939::null_address;
  std::optional<std::uint8_t> instance;
  std::optional<std::uint8_t> direction_order;  ///< 0 none, 1 to starboard, 2 to port
  std::optional<double> angle_order_rad;
  std::optional<double> position_rad;  ///< positive turns the vehicle to starboard
};

/// Engine parameters, rapid update. Here they are those of the propeller shaft.
struct Engine {
  static constexpr std::string_view type = "engine";
  std::uint8_t source = j1939::null_address;
  std::optional<std::uint8_t> instance;
  std::optional<double> speed_radps;
  std::optional<double> boost_pressure_pa;
  std::optional<double> tilt_percent;
};

/// Position fix: a fast packet of at least 43 bytes.
struct GnssPosition {
  static constexpr std::string_view type = "gnss_position";
  std::uint8_t source = j1939::null_address;
  std::optional<std::uint8_t> sequence;
  std::optional<std::int64_t> utc_ns;  ///< since 1970
  std::optional<double> latitude_rad, longitude_rad;
  std::optional<double> altitude_m;            ///< above the WGS-84 ellipsoid
  std::optional<std::uint8_t> system, method;  ///< method 0 no fix, 1 GNSS, 2 DGNSS, 3 precise, ...
  std::optional<std::uint8_t> satellites;
  std::optional<double> horizontal_dop, position_dop;
  std::optional<double> geoid_height_m;
};

/// Empty if the payload is shorter than the message.
std::optional<Pressure> decode_pressure(std::uint8_t source, Bytes payload);
std::optional<Temperature> decode_temperature(std::uint8_t source, Bytes payload);
std::optional<WaterDepth> decode_water_depth(std::uint8_t source, Bytes payload);
std::optional<Rudder> decode_rudder(std::uint8_t source, Bytes payload);
std::optional<Engine> decode_engine(std::uint8_t source, Bytes payload);
std::optional<GnssPosition> decode_gnss_position(std::uint8_t source, Bytes payload);

/// A value beyond the range of the wire is sent as "out of range", an empty value as "not
/// available".
CanFrame encode(const Pressure& message);
CanFrame encode(const Temperature& message);
CanFrame encode(const WaterDepth& message);
CanFrame encode(const Rudder& message);
CanFrame encode(const Engine& message);

template <class Field>
void visit_fields(const Pressure& m, Field&& field) {
  field("source", m.source);
  field("sequence", m.sequence);
  field("instance", m.instance);
  field("kind", m.kind);
  field("pressure_pa", m.pressure_pa);
}

template <class Field>
void visit_fields(const Temperature& m, Field&& field) {
  field("source", m.source);
  field("sequence", m.sequence);
  field("instance", m.instance);
  field("kind", m.kind);
  field("actual_k", m.actual_k);
  field("set_k", m.set_k);
}

template <class Field>
void visit_fields(const WaterDepth& m, Field&& field) {
  field("source", m.source);
  field("sequence", m.sequence);
  field("depth_m", m.depth_m);
  field("offset_m", m.offset_m);
  field("maximum_range_m", m.maximum_range_m);
}

template <class Field>
void visit_fields(const Rudder& m, Field&& field) {
  field("source", m.source);
  field("instance", m.instance);
  field("direction_order", m.direction_order);
  field("angle_order_rad", m.angle_order_rad);
  field("position_rad", m.position_rad);
}

template <class Field>
void visit_fields(const Engine& m, Field&& field) {
  field("source", m.source);
  field("instance", m.instance);
  field("speed_radps", m.speed_radps);
  field("boost_pressure_pa", m.boost_pressure_pa);
  field("tilt_percent", m.tilt_percent);
}

template <class Field>
void visit_fields(const GnssPosition& m, Field&& field) {
  field("source", m.source);
  field("sequence", m.sequence);
  field("utc_ns", m.utc_ns);
  field("latitude_rad", m.latitude_rad);
  field("longitude_rad", m.longitude_rad);
  field("altitude_m", m.altitude_m);
  field("system", m.system);
  field("method", m.method);
  field("satellites", m.satellites);
  field("horizontal_dop", m.horizontal_dop);
  field("position_dop", m.position_dop);
  field("geoid_height_m", m.geoid_height_m);
}

}  // namespace drydock::wire::nmea2000
