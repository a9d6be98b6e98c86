#pragma once

#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>

/// Scaled integers of CAN messages. The highest values of a field are not numbers. NMEA 2000
/// reserves three ("not available", "out of range", "reserved"), J1939 everything from 0xFB.. up.
/// No function here returns them as a number.
namespace drydock::wire {

template <std::integral Raw>
struct Sentinels {
  static constexpr Raw not_available = std::numeric_limits<Raw>::max();
  static constexpr Raw out_of_range = not_available - 1;
  static constexpr Raw reserved = not_available - 2;
};

/// NMEA 2000: an unscaled number.
template <std::integral Raw>
std::optional<Raw> number_field(Raw raw) {
  if (raw >= Sentinels<Raw>::reserved) return std::nullopt;
  return raw;
}

/// Size of one step as a fraction, so that decimal steps are rounded correctly.
struct Resolution {
  double numerator = 1, denominator = 1;
};

/// NMEA 2000: raw * resolution.
template <std::integral Raw>
std::optional<double> scaled_field(Raw raw, Resolution step) {
  if (raw >= Sentinels<Raw>::reserved) return std::nullopt;
  return static_cast<double>(raw) * step.numerator / step.denominator;
}

/// NMEA 2000: an empty value becomes "not available", a value that does not fit "out of range".
template <std::integral Raw>
Raw to_scaled_field(const std::optional<double>& value, Resolution step) {
  if (!value || !std::isfinite(*value)) return Sentinels<Raw>::not_available;
  const double raw = std::round(*value * step.denominator / step.numerator);
  const bool fits = raw >= static_cast<double>(std::numeric_limits<Raw>::min()) &&
                    raw < static_cast<double>(Sentinels<Raw>::reserved);
  return fits ? static_cast<Raw>(raw) : Sentinels<Raw>::out_of_range;
}

/// J1939, unsigned field of 8, 16 or 24 bits. Its zero is at `zero` steps.
template <unsigned Bits>
std::optional<double> j1939_field(std::uint32_t raw, double zero, double steps_per_unit) {
  constexpr std::uint32_t first_reserved = 0xFBu << (Bits - 8);
  if (raw >= first_reserved) return std::nullopt;
  return (raw - zero) / steps_per_unit;
}

/// J1939: an empty value becomes "not available" (all ones), a value that does not fit "error"
/// (0xFE..).
template <unsigned Bits>
std::uint32_t to_j1939_field(const std::optional<double>& value, double zero,
                             double steps_per_unit) {
  constexpr std::uint32_t first_reserved = 0xFBu << (Bits - 8);
  constexpr std::uint32_t error = 0xFEu << (Bits - 8);
  constexpr std::uint32_t not_available = (1u << Bits) - 1;
  if (!value || !std::isfinite(*value)) return not_available;
  const double raw = std::round(*value * steps_per_unit + zero);
  return raw >= 0 && raw < first_reserved ? static_cast<std::uint32_t>(raw) : error;
}

}  // namespace drydock::wire
