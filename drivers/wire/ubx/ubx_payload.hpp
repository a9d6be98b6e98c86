#pragma once

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <optional>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/codec.hpp"
#include "drivers/wire/fields.hpp"

/// Common field types of UBX payloads, and the value of each that means "unknown" (u-blox interface
/// descriptions, M8 to F9). Offsets are in bytes. An integer of the wire is divided by
/// `steps_per_unit`, so that a decimal gives the double nearest to it.
namespace drydock::wire::ubx {

template <class T>
double value(Bytes payload, std::size_t offset, double steps_per_unit) {
  return load_le<T>(payload, offset) / steps_per_unit;
}

/// FFFFFFFF means that the receiver has no estimate.
inline std::optional<double> accuracy(Bytes payload, std::size_t offset, double steps_per_unit) {
  const auto raw = load_le<std::uint32_t>(payload, offset);
  return raw == 0xFFFF'FFFF ? std::nullopt : std::optional{raw / steps_per_unit};
}

/// 0 dBHz means that the signal is not tracked.
inline std::optional<double> carrier_to_noise(Bytes payload, std::size_t offset) {
  return payload[offset] > 0 ? std::optional<double>{payload[offset]} : std::nullopt;
}

/// In hundredths; 99.99 means no value.
inline std::optional<double> dop(Bytes payload, std::size_t offset) {
  return dilution(value<std::uint16_t>(payload, offset, 1e2));
}

/// Two bits: 0 unknown, 1 healthy, 2 not healthy.
inline std::optional<bool> health(unsigned two_bits) {
  if (two_bits != 1 && two_bits != 2) return {};
  return two_bits == 1;
}

constexpr bool bit(unsigned word, unsigned number) { return (word >> number & 1u) != 0; }

inline std::chrono::milliseconds itow(Bytes payload) {
  return std::chrono::milliseconds{load_le<std::uint32_t>(payload, 0)};
}

inline std::optional<std::chrono::year_month_day> date(Bytes payload, std::size_t offset) {
  const std::chrono::year_month_day date{std::chrono::year{load_le<std::uint16_t>(payload, offset)},
                                         std::chrono::month{payload[offset + 2]},
                                         std::chrono::day{payload[offset + 3]}};
  return date.ok() ? std::optional{date} : std::nullopt;
}

/// Hour, minute, second in three bytes, corrected by a signed fraction.
inline std::chrono::nanoseconds time_of_day(Bytes payload, std::size_t offset,
                                            std::size_t fraction) {
  return std::chrono::hours{payload[offset]} + std::chrono::minutes{payload[offset + 1]} +
         std::chrono::seconds{payload[offset + 2]} +
         std::chrono::nanoseconds{load_le<std::int32_t>(payload, fraction)};
}

/// Longitude and latitude as two integers of 1e-7 degree. False if they are outside of the globe.
/// Division by an exact 1e7 keeps the degrees correctly rounded.
inline bool read_position(Bytes payload, std::size_t offset, std::optional<double>& latitude_rad,
                          std::optional<double>& longitude_rad) {
  const auto longitude = load_le<std::int32_t>(payload, offset);
  const auto latitude = load_le<std::int32_t>(payload, offset + 4);
  if (std::abs(std::int64_t{longitude}) > 1'800'000'000 ||
      std::abs(std::int64_t{latitude}) > 900'000'000) {
    return false;
  }
  longitude_rad = radians(longitude / 1e7);
  latitude_rad = radians(latitude / 1e7);
  return true;
}

/// Degrees in one and two bytes. An elevation beyond 90 degrees makes both values unknown.
inline void read_direction(Bytes payload, std::size_t offset, std::optional<double>& elevation_rad,
                           std::optional<double>& azimuth_rad) {
  const int elevation_deg = load_le<std::int8_t>(payload, offset);
  const int azimuth_deg = load_le<std::int16_t>(payload, offset + 1);
  if (std::abs(elevation_deg) > 90) return;
  elevation_rad = radians(elevation_deg);
  if (azimuth_deg >= 0 && azimuth_deg <= 360) azimuth_rad = radians(azimuth_deg);
}

}  // namespace drydock::wire::ubx
