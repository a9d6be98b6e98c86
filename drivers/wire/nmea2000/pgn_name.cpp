#include "drivers/wire/nmea2000/pgn_name.hpp"

#include <algorithm>
#include <array>

namespace drydock::wire::nmea2000 {
namespace {

/// The first and the last PGN of that name, in the order of canboat's public PGN database.
struct NamedRange {
  std::uint32_t first, last;
  std::string_view name;
};
constexpr NamedRange one(std::uint32_t pgn, std::string_view name) { return {pgn, pgn, name}; }

constexpr std::array named{one(59392, "acknowledgement"),
                           one(60160, "transport data"),
                           one(60416, "transport control"),
                           NamedRange{61184, 61439, "proprietary"},
                           one(65240, "commanded address"),
                           NamedRange{65280, 65535, "proprietary"},
                           one(126208, "group function"),
                           one(126464, "PGN list"),
                           one(126720, "proprietary"),
                           one(126983, "alert"),
                           one(126993, "heartbeat"),
                           one(126996, "product information"),
                           one(126998, "configuration information"),
                           one(127233, "man overboard"),
                           one(127489, "engine, dynamic"),
                           one(127493, "transmission"),
                           one(127497, "trip fuel"),
                           one(127501, "switch bank"),
                           one(127505, "fluid level"),
                           one(127506, "DC status"),
                           one(127508, "battery"),
                           one(127513, "battery configuration"),
                           one(129033, "local time"),
                           NamedRange{129038, 129041, "AIS"},
                           one(129044, "datum"),
                           one(129283, "cross track error"),
                           one(129284, "navigation to waypoint"),
                           one(129285, "route and waypoints"),
                           one(129541, "GPS almanac"),
                           one(129542, "GNSS pseudorange noise"),
                           one(129547, "GNSS pseudorange error"),
                           NamedRange{129792, 129813, "AIS"},
                           one(130306, "wind"),
                           one(130313, "humidity"),
                           one(130316, "temperature, extended"),
                           one(130577, "direction"),
                           one(130578, "speed components"),
                           NamedRange{130816, 131071, "proprietary"}};

}  // namespace

std::string_view pgn_name(std::uint32_t pgn) {
  const auto found = std::ranges::find_if(
      named, [&](const NamedRange& range) { return range.first <= pgn && pgn <= range.last; });
  return found == named.end() ? std::string_view() : found->name;
}

}  // namespace drydock::wire::nmea2000
