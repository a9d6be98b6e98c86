#include "drivers/wire/nmea2000/nmea2000_messages.hpp"

#include <numbers>

#include "drivers/wire/bit_field.hpp"
#include "drivers/wire/bytes.hpp"
#include "drivers/wire/fields.hpp"

namespace drydock::wire::nmea2000 {

namespace {

constexpr std::size_t single_frame = 8;

constexpr Resolution decipascal_step{1, 10};
constexpr Resolution centikelvin_step{1, 100};
constexpr Resolution centimetre_step{1, 100};
constexpr Resolution millimetre_step{1, 1000};
constexpr Resolution ten_metre_step{10, 1};
constexpr Resolution angle_step{1, 10000};
constexpr Resolution shaft_step{std::numbers::pi, 120};  // 0.25 revolutions per minute in rad/s
constexpr Resolution hectopascal_step{100, 1};
constexpr Resolution percent_step{1, 1};

std::uint8_t or_not_available(const std::optional<std::uint8_t>& value) {
  return value.value_or(Sentinels<std::uint8_t>::not_available);
}

CanFrame frame_for(std::uint8_t priority, std::uint32_t pgn, std::uint8_t source) {
  return j1939::blank_frame({priority, pgn, j1939::global_address, source});
}

}  // namespace

std::optional<Pressure> decode_pressure(std::uint8_t source, Bytes p) {
  if (p.size() < single_frame) return std::nullopt;
  return Pressure{source, number_field(p[0]), number_field(p[1]), number_field(p[2]),
                  scaled_field(load_le<std::int32_t>(p, 3), decipascal_step)};
}

std::optional<Temperature> decode_temperature(std::uint8_t source, Bytes p) {
  if (p.size() < single_frame) return std::nullopt;
  return Temperature{source,
                     number_field(p[0]),
                     number_field(p[1]),
                     number_field(p[2]),
                     scaled_field(load_le<std::uint16_t>(p, 3), centikelvin_step),
                     scaled_field(load_le<std::uint16_t>(p, 5), centikelvin_step)};
}

std::optional<WaterDepth> decode_water_depth(std::uint8_t source, Bytes p) {
  if (p.size() < single_frame) return std::nullopt;
  return WaterDepth{source, number_field(p[0]),
                    scaled_field(load_le<std::uint32_t>(p, 1), centimetre_step),
                    scaled_field(load_le<std::int16_t>(p, 5), millimetre_step),
                    scaled_field(p[7], ten_metre_step)};
}

std::optional<Rudder> decode_rudder(std::uint8_t source, Bytes p) {
  if (p.size() < single_frame) return std::nullopt;
  Rudder m{source, number_field(p[0]), std::nullopt,
           scaled_field(load_le<std::int16_t>(p, 2), angle_step),
           scaled_field(load_le<std::int16_t>(p, 4), angle_step)};
  const std::uint8_t order = p[1] & 7;
  if (order != 7) m.direction_order = order;
  return m;
}

std::optional<Engine> decode_engine(std::uint8_t source, Bytes p) {
  if (p.size() < single_frame) return std::nullopt;
  return Engine{source, number_field(p[0]), scaled_field(load_le<std::uint16_t>(p, 1), shaft_step),
                scaled_field(load_le<std::uint16_t>(p, 3), hectopascal_step),
                scaled_field(load_le<std::int8_t>(p, 5), percent_step)};
}

CanFrame encode(const Pressure& m) {
  CanFrame frame = frame_for(5, pressure_pgn, m.source);
  frame.data[0] = or_not_available(m.sequence);
  frame.data[1] = or_not_available(m.instance);
  frame.data[2] = or_not_available(m.kind);
  store_le<std::int32_t>(frame.data, 3,
                         to_scaled_field<std::int32_t>(m.pressure_pa, decipascal_step));
  return frame;
}

CanFrame encode(const Temperature& m) {
  CanFrame frame = frame_for(5, temperature_pgn, m.source);
  frame.data[0] = or_not_available(m.sequence);
  frame.data[1] = or_not_available(m.instance);
  frame.data[2] = or_not_available(m.kind);
  store_le<std::uint16_t>(frame.data, 3,
                          to_scaled_field<std::uint16_t>(m.actual_k, centikelvin_step));
  store_le<std::uint16_t>(frame.data, 5, to_scaled_field<std::uint16_t>(m.set_k, centikelvin_step));
  return frame;
}

CanFrame encode(const WaterDepth& m) {
  CanFrame frame = frame_for(3, water_depth_pgn, m.source);
  frame.data[0] = or_not_available(m.sequence);
  store_le<std::uint32_t>(frame.data, 1,
                          to_scaled_field<std::uint32_t>(m.depth_m, centimetre_step));
  store_le<std::int16_t>(frame.data, 5, to_scaled_field<std::int16_t>(m.offset_m, millimetre_step));
  frame.data[7] = to_scaled_field<std::uint8_t>(m.maximum_range_m, ten_metre_step);
  return frame;
}

CanFrame encode(const Rudder& m) {
  CanFrame frame = frame_for(2, rudder_pgn, m.source);
  frame.data[0] = or_not_available(m.instance);
  frame.data[1] = static_cast<std::uint8_t>(0xF8 | (m.direction_order.value_or(7) & 7));
  store_le<std::int16_t>(frame.data, 2,
                         to_scaled_field<std::int16_t>(m.angle_order_rad, angle_step));
  store_le<std::int16_t>(frame.data, 4, to_scaled_field<std::int16_t>(m.position_rad, angle_step));
  return frame;
}

CanFrame encode(const Engine& m) {
  CanFrame frame = frame_for(2, engine_pgn, m.source);
  frame.data[0] = or_not_available(m.instance);
  store_le<std::uint16_t>(frame.data, 1, to_scaled_field<std::uint16_t>(m.speed_radps, shaft_step));
  store_le<std::uint16_t>(frame.data, 3,
                          to_scaled_field<std::uint16_t>(m.boost_pressure_pa, hectopascal_step));
  store_le<std::int8_t>(frame.data, 5, to_scaled_field<std::int8_t>(m.tilt_percent, percent_step));
  return frame;
}

}  // namespace drydock::wire::nmea2000
