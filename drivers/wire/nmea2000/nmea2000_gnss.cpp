#include <cmath>

#include "drivers/wire/bit_field.hpp"
#include "drivers/wire/bytes.hpp"
#include "drivers/wire/fields.hpp"
#include "drivers/wire/nmea2000/nmea2000_messages.hpp"

namespace drydock::wire::nmea2000 {

namespace {

constexpr std::size_t shortest = 43;  // without reference stations
constexpr std::uint8_t no_fix = 0;

constexpr Resolution degree_step{1, 1e16};
constexpr Resolution micrometre_step{1, 1e6};
constexpr Resolution centi_step{1, 100};

std::optional<std::int64_t> utc_ns(std::uint16_t days, std::uint32_t time) {
  constexpr std::int64_t ns_per_day = 86400LL * 1000000000, ns_per_step = 100000;
  const auto day = number_field(days);
  const auto step = number_field(time);
  if (!day || !step) return std::nullopt;
  return *day * ns_per_day + *step * ns_per_step;
}

std::optional<std::uint8_t> half_byte(unsigned bits) {
  if (bits >= 14) return std::nullopt;  // 14 error, 15 not available
  return static_cast<std::uint8_t>(bits);
}

std::optional<double> angle(std::int64_t raw, double limit_deg) {
  const auto deg = scaled_field(raw, degree_step);
  if (!deg || std::abs(*deg) > limit_deg) return std::nullopt;
  return radians(*deg);
}

/// Receivers without a fix send 0xFFFF. In earlier versions the field was unsigned and this was
/// "not available".
std::optional<double> dilution(std::int16_t raw) {
  if (raw < 0) return std::nullopt;
  return scaled_field(raw, centi_step);
}

}  // namespace

std::optional<GnssPosition> decode_gnss_position(std::uint8_t source, Bytes p) {
  if (p.size() < shortest) return std::nullopt;
  GnssPosition m;
  m.source = source;
  m.sequence = number_field(p[0]);
  m.utc_ns = utc_ns(load_le<std::uint16_t>(p, 1), load_le<std::uint32_t>(p, 3));
  m.system = half_byte(p[31] & 0xF);
  m.method = half_byte(p[31] >> 4);
  if (m.method.value_or(no_fix) != no_fix) {
    m.latitude_rad = angle(load_le<std::int64_t>(p, 7), 90);
    m.longitude_rad = angle(load_le<std::int64_t>(p, 15), 180);
    m.altitude_m = scaled_field(load_le<std::int64_t>(p, 23), micrometre_step);
  }
  m.satellites = number_field(p[33]);
  m.horizontal_dop = dilution(load_le<std::int16_t>(p, 34));
  m.position_dop = dilution(load_le<std::int16_t>(p, 36));
  m.geoid_height_m = scaled_field(load_le<std::int32_t>(p, 38), centi_step);
  return m;
}

}  // namespace drydock::wire::nmea2000
