#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace drydock::measurement {

/// The kind of a sensor.
enum class Kind : std::uint8_t { dvl, emlog, gnss, imu, depth, actuator, attitude };

inline constexpr std::array kinds{Kind::dvl,   Kind::emlog,    Kind::gnss,    Kind::imu,
                                  Kind::depth, Kind::actuator, Kind::attitude};

/// The name in rig files, sensor files and messages.
constexpr std::string_view to_string(Kind kind) {
  constexpr std::array<std::string_view, kinds.size()> names{"dvl",   "emlog",    "gnss",    "imu",
                                                             "depth", "actuator", "attitude"};
  return names[static_cast<std::size_t>(kind)];
}

/// Empty if no kind has that name.
constexpr std::optional<Kind> kind_of(std::string_view name) {
  for (const Kind kind : kinds)
    if (to_string(kind) == name) return kind;
  return std::nullopt;
}

/// The maker of a DVL, for the axes of PD4 and PD6. Teledyne's are starboard, bow, mast, or those
/// of the frame that the report names. Water Linked's are always forward, starboard, down.
enum class DvlMaker : std::uint8_t { teledyne, water_linked };

}  // namespace drydock::measurement
