#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "drivers/wire/j1939/j1939.hpp"
#include "hil/emulate/memory.hpp"

namespace drydock::emulate {

/// What other nodes may set of an NMEA 2000 device, and what it keeps without power.
struct Nmea2000Settings {
  static constexpr std::size_t most_characters = 70;  ///< of a description

  struct Text {
    std::uint8_t encoding = 1;  ///< 0: UTF-16, 1: ASCII
    std::string bytes;
  };
  std::uint8_t device_instance = 0;  ///< 8 bits; the lower 3 and the upper 5 are fields of the NAME
  std::uint8_t system_instance = 0;  ///< 4 bits
  std::array<Text, 2> descriptions;  ///< of the installation

  /// A NAME with these instances.
  std::uint64_t in(std::uint64_t name) const {
    auto parts = wire::j1939::to_name(name);
    parts.ecu_instance = device_instance & 7;
    parts.function_instance = device_instance >> 3;
    parts.vehicle_system_instance = system_instance;
    return wire::j1939::to_value(parts);
  }
};

Nmea2000Settings settings_in(const Memory& memory);
void keep(const Nmea2000Settings& settings, Memory& memory);

}  // namespace drydock::emulate
