#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace drydock::conformance {

struct Position {
  double latitude_deg, longitude_deg;
};

/// The same to half a step of 1e-7 degrees, in which receivers send.
bool same_place(const Position& a, const Position& b);

/// A position as it stands on the wire, and whether its sentence vouches for it: NAV-PVT with
/// gnssFixOK and a fix, GGA with quality 1 to 6, RMC and GLL with A.
struct WirePosition {
  Position place;
  std::string epoch;  ///< iTOW or time of day, as sent
  bool vouched_for = false;
};

/// Of NAV-PVT, GGA, RMC, GNS and GLL with a good checksum, read by their columns alone.
std::vector<WirePosition> scan_positions(std::string_view bytes);

}  // namespace drydock::conformance
