#pragma once

#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "estimators/frame/geodetic.hpp"
#include "hil/sky/broadcast_orbits.hpp"
#include "hil/sky/look.hpp"
#include "hil/sky/orbit.hpp"

/// `drydock sky`: the satellite positions of a broadcast file at one time.
namespace drydock::world {

struct SkyOptions {
  std::string ephemeris;            ///< RINEX 2 or 3 GPS navigation file
  std::string at;                   ///< read by parse_instant
  std::optional<std::string> from;  ///< read by parse_place
  bool json = false;
  std::string plot;  ///< SVG file to write; empty: none
};

/// 2010-07-01T12:00:00 with an optional fraction, then "Z" or nothing (UTC), or " GPS".
std::optional<sky::GpsTime> parse_instant(std::string_view text);

/// "36.1,129.4" or "36.1,129.4,25": degrees north and east, metres above the ellipsoid.
std::optional<frame::Position> parse_place(std::string_view text);

struct SkyRow {
  sky::Ephemeris record;
  sky::SatelliteState state;
  std::optional<sky::Look> look;  ///< only if a place was given
};

struct SkyListing {
  sky::GpsTime at;
  std::optional<frame::Position> from;
  std::vector<SkyRow> rows;  ///< by elevation, highest first; without a place by number
  sky::BroadcastOrbits orbits;
};

/// Uses the nearest healthy record of each satellite, or the nearest of all if none is healthy.
SkyListing list_sky(sky::BroadcastOrbits orbits, sky::GpsTime at,
                    const std::optional<frame::Position>& from);

/// Exit code: 0; 1 with a line on `errors` if the file cannot be read or has no record for that
/// time.
int show_sky(const SkyOptions& options, std::FILE* out, std::FILE* errors);

}  // namespace drydock::world
