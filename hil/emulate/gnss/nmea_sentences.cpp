#include "hil/emulate/gnss/nmea_sentences.hpp"

#include <algorithm>

namespace drydock::emulate {

wire::Rmc rmc(const GnssEpoch& epoch) {
  wire::Rmc m;
  if (epoch.time_is_known) {
    m.time_of_day = epoch.time_of_day;
    m.date = epoch.date;
  }
  m.mode = 'N';
  const auto& fix = epoch.fix;
  if (!fix.position) return m;
  m.valid = true;
  m.mode = 'A';
  m.latitude_rad = fix.position->latitude_rad;
  m.longitude_rad = fix.position->longitude_rad;
  m.speed_mps = fix.velocity_ned->head<2>().norm();
  m.course_rad = course_rad(*fix.velocity_ned);
  return m;
}

wire::Gga gga(const GnssEpoch& epoch) {
  wire::Gga m;
  if (epoch.time_is_known) m.time_of_day = epoch.time_of_day;
  m.quality = 0;
  m.satellites_used = epoch.fix.satellites_used;
  const auto& fix = epoch.fix;
  if (!fix.position) return m;
  m.quality = 1;
  m.latitude_rad = fix.position->latitude_rad;
  m.longitude_rad = fix.position->longitude_rad;
  m.horizontal_dop = epoch.dilution->horizontal;
  m.mean_sea_level_height_m = fix.mean_sea_level_height_m;
  m.geoid_separation_m = *fix.ellipsoidal_height_m - *fix.mean_sea_level_height_m;
  return m;
}

wire::Gsa gsa(const GnssEpoch& epoch) {
  wire::Gsa m;
  m.selection = 'A';
  m.fix_type = epoch.fix.position ? 3 : 1;
  for (const auto& satellite : epoch.sky.satellites) {
    if (satellite.used && m.satellites_used.size() < m.satellites_used.capacity()) {
      m.satellites_used.push_back(satellite.number);
    }
  }
  if (!epoch.fix.position) return m;
  m.position_dop = epoch.dilution->position;
  m.horizontal_dop = epoch.dilution->horizontal;
  m.vertical_dop = epoch.dilution->vertical;
  return m;
}

wire::Vtg vtg(const GnssEpoch& epoch) {
  wire::Vtg m;
  m.mode = 'N';
  if (!epoch.fix.velocity_ned) return m;
  m.mode = 'A';
  m.course_true_rad = course_rad(*epoch.fix.velocity_ned);
  m.speed_mps = epoch.fix.velocity_ned->head<2>().norm();
  return m;
}

wire::Zda zda(const GnssEpoch& epoch) {
  wire::Zda m;
  if (epoch.time_is_known) {
    m.time_of_day = epoch.time_of_day;
    m.date = epoch.date;
  }
  m.zone_hours = m.zone_minutes = 0;
  return m;
}

wire::Gll gll(const GnssEpoch& epoch) {
  wire::Gll m;
  if (epoch.time_is_known) m.time_of_day = epoch.time_of_day;
  m.mode = 'N';
  if (!epoch.fix.position) return m;
  m.valid = true;
  m.mode = 'A';
  m.latitude_rad = epoch.fix.position->latitude_rad;
  m.longitude_rad = epoch.fix.position->longitude_rad;
  return m;
}

int gsv_sentences(const GnssEpoch& epoch) {
  return static_cast<int>(std::max<std::size_t>(
      1, (epoch.sky.satellites.size() + gsv_satellites - 1) / gsv_satellites));
}

wire::Gsv gsv(const GnssEpoch& epoch, int number) {
  const auto& all = epoch.sky.satellites;
  wire::Gsv m;
  m.sentences = gsv_sentences(epoch);
  m.sentence_number = number;
  m.satellites_in_view = static_cast<int>(all.size());
  const std::size_t from = gsv_satellites * static_cast<std::size_t>(number - 1);
  for (std::size_t i = from; i < std::min(all.size(), from + gsv_satellites); ++i)
    m.satellites.push_back(
        {all[i].number, all[i].elevation_rad, all[i].azimuth_rad, all[i].cno_dbhz});
  return m;
}

}  // namespace drydock::emulate
