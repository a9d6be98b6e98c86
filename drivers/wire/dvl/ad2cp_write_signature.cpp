#include <cmath>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/dvl/ad2cp_frame.hpp"
#include "drivers/wire/dvl/ad2cp_read.hpp"
#include "drivers/wire/dvl/ad2cp_write.hpp"
#include "drivers/wire/dvl/nortek_ad2cp.hpp"

namespace drydock::wire::ad2cp {
namespace {

constexpr std::size_t fixed_part = 78, velocity_size = 4, beams = 4;
constexpr std::size_t data_size = fixed_part + 2 * velocity_size * beams;
constexpr int step_exponent = -4;  ///< velocities in 0.1 mm/s
constexpr std::int32_t no_bottom_mm = -1022;
constexpr double pa_per_mdbar = 10;

constexpr unsigned has_pressure = 1, has_temperature = 2, has_compass = 4, has_tilt = 8,
                   has_velocity = 1 << 5, has_distance = 1 << 8;

unsigned configuration_of(const SignatureBottomTrack& m) {
  return (m.pressure_pa ? has_pressure : 0) | (m.temperature_k ? has_temperature : 0) |
         (m.heading_rad ? has_compass : 0) | (m.pitch_rad && m.roll_rad ? has_tilt : 0) |
         has_velocity | has_distance;
}

template <class Integer>
void put(std::span<std::uint8_t> data, std::size_t at, double value) {
  store_le<Integer>(data, at, static_cast<Integer>(std::lround(value)));
}

void put_sensors(const SignatureBottomTrack& m, std::span<std::uint8_t> data) {
  put<std::uint16_t>(data, 16, 10 * m.sound_speed_mps.value_or(0));
  put<std::int16_t>(data, 18, 100 * (m.temperature_k.value_or(zero_celsius_k) - zero_celsius_k));
  put<std::uint32_t>(data, 20, std::max(0.0, m.pressure_pa.value_or(0) / pa_per_mdbar));
  const double turn = std::remainder(degrees(m.heading_rad).value_or(0), 360);
  put<std::uint16_t>(data, 24, 100 * (turn < 0 ? turn + 360 : turn));
  put<std::int16_t>(data, 26, 100 * degrees(m.pitch_rad).value_or(0));
  put<std::int16_t>(data, 28, 100 * degrees(m.roll_rad).value_or(0));
  put<std::uint16_t>(data, 38, 10 * m.battery_v);
}

}  // namespace

std::size_t encode(const SignatureBottomTrack& m, std::span<std::uint8_t> out) {
  if (out.size() < short_header + data_size) return 0;
  const auto data = out.subspan(short_header, data_size);
  std::ranges::fill(data, std::uint8_t{0});
  data[0] = static_cast<std::uint8_t>(m.version);
  data[1] = fixed_part;
  store_le<std::uint16_t>(data, 2, static_cast<std::uint16_t>(configuration_of(m)));
  store_le<std::uint32_t>(data, 4, m.serial_number);
  if (m.clock) write_clock(*m.clock, data.subspan(8));
  put_sensors(m, data);
  store_le<std::uint16_t>(
      data, 30, static_cast<std::uint16_t>(beams << 12 | static_cast<unsigned>(m.axes) << 10));
  const double step_mps = std::pow(10.0, step_exponent);
  put<std::uint32_t>(data, 52, m.ambiguity_velocity_mps / step_mps);
  data[60] = static_cast<std::uint8_t>(step_exponent);
  store_le<std::uint32_t>(data, 66, m.error);
  store_le<std::uint32_t>(data, 70, m.status);
  store_le<std::uint32_t>(data, 74, m.ensemble);
  for (std::size_t i = 0; i < beams; ++i) {
    put<std::int32_t>(data, fixed_part + velocity_size * i,
                      m.velocity_mps[i].value_or(-m.ambiguity_velocity_mps) / step_mps);
    put<std::int32_t>(data, fixed_part + velocity_size * (beams + i),
                      m.distance_m[i] ? 1000 * *m.distance_m[i] : no_bottom_mm);
  }
  return close_record(signature_bottom_track_id, dvl_family, data_size, out);
}

}  // namespace drydock::wire::ad2cp
