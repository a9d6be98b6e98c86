#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace drydock::conformance {

struct Position {
  double latitude_deg, longitude_deg;
};

/// True if they differ by at most half a step of 1e-7 degrees, the resolution of receivers.
bool same_place(const Position& a, const Position& b);

/// A position on the wire, and whether its sentence marks it as valid: NAV-PVT with gnssFixOK and a
/// fix, GGA with quality 1 to 6, RMC and GLL with A.
struct WirePosition {
  Position place;
  std::string epoch;  ///< iTOW or time of day, as sent
  bool vouched_for = false;
  bool by_no_satellites = false;  ///< GGA: a fix, and 0 satellites used
};

/// From NAV-PVT, GGA, RMC, GNS and GLL with a right checksum, read only by their columns.
std::vector<WirePosition> scan_positions(std::string_view bytes);

}  // namespace drydock::conformance
