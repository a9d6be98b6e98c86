#include "drivers/device/gnss/ubx_satellite_list.hpp"

#include <algorithm>

namespace drydock::device {

using measurement::Constellation;
using measurement::Satellite;

namespace {

constexpr std::uint8_t unnamed = 255;  // a GLONASS satellite before its slot is known

template <class Seen>
bool has_name(const Seen& s) {
  return s.gnss <= wire::UbxGnss::navic && s.number != unnamed;
}

}  // namespace

SatelliteList satellite_list(std::span<const wire::UbxSatellite> satellites) {
  SatelliteList list;
  for (const wire::UbxSatellite& s : satellites) {
    if (!has_name(s) || list.size() == list.capacity()) continue;
    list.push_back({static_cast<Constellation>(s.gnss), s.number, s.cno_dbhz, s.elevation_rad,
                    s.azimuth_rad, s.used});
  }
  return list;
}

SatelliteList satellite_list(std::span<const wire::UbxSignal> signals) {
  SatelliteList list;
  for (const wire::UbxSignal& s : signals) {
    if (!has_name(s)) continue;
    const auto constellation = static_cast<Constellation>(s.gnss);
    const bool used = s.pseudorange_used || s.carrier_used || s.doppler_used;
    const auto same = std::ranges::find_if(list, [&](const Satellite& known) {
      return known.constellation == constellation && known.number == s.number;
    });
    if (same == list.end()) {
      if (list.size() < list.capacity()) {
        list.push_back({constellation, s.number, s.cno_dbhz, {}, {}, used});
      }
      continue;
    }
    same->cno_dbhz = std::max(same->cno_dbhz, s.cno_dbhz);  // empty is the least value
    same->used = same->used || used;
  }
  return list;
}

}  // namespace drydock::device
