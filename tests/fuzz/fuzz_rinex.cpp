#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "hil/sky/broadcast_orbits.hpp"
#include "hil/sky/orbit.hpp"
#include "hil/sky/rinex.hpp"

using namespace drydock;

/// Any text is refused with a line or gives records. Every selected record gives a position in
/// space.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto file = sky::read_navigation({reinterpret_cast<const char*>(data), size});
  if (!file) {
    if (file.error().line < 1) std::abort();
    return 0;
  }
  const sky::BroadcastOrbits orbits(file->records);
  for (const sky::Ephemeris& record : file->records) {
    const auto* chosen = orbits.nearest(record.prn, record.toe);
    if (chosen && !std::isfinite(satellite_at(*chosen, record.toe).ecef_m.norm())) std::abort();
  }
  return 0;
}
