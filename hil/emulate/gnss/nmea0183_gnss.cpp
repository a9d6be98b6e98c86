#include "drivers/wire/nmea0183/nmea0183.hpp"
#include "hil/emulate/devices.hpp"
#include "hil/emulate/gnss/gnss_epoch.hpp"

namespace drydock::emulate {
namespace {

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

class Nmea0183Gnss final : public SamplingDevice {
 public:
  explicit Nmea0183Gnss(const DeviceSetup& setup) : SamplingDevice(setup), sensor_(setup) {
    sample_at_whole_multiples();
  }

 private:
  void sample(Stamp at, Wire& out) override {
    const GnssEpoch epoch = sensor_.measure(trajectory().at(at), mounting());
    send(rmc(epoch), out);
    send(gga(epoch), out);
    send(gsa(epoch), out);
    send_satellites(epoch, out);
    send(vtg(epoch), out);
    send(zda(epoch), out);
  }

  void send_satellites(const GnssEpoch& epoch, Wire& out) {
    constexpr std::size_t in_one = 4;
    const auto& all = epoch.sky.satellites;
    wire::Gsv m;
    m.sentences = static_cast<int>(std::max<std::size_t>(1, (all.size() + in_one - 1) / in_one));
    m.satellites_in_view = static_cast<int>(all.size());
    for (int n = 0; n < *m.sentences; ++n) {
      m.sentence_number = n + 1;
      m.satellites.clear();
      const std::size_t from = in_one * static_cast<std::size_t>(n);
      for (std::size_t i = from; i < std::min(all.size(), from + in_one); ++i) {
        m.satellites.push_back(
            {all[i].number, all[i].elevation_rad, all[i].azimuth_rad, all[i].cno_dbhz});
      }
      send(m, out);
    }
  }

  template <class Sentence>
  void send(const Sentence& sentence, Wire& out) {
    out.send(wire::Bytes{bytes_}.first(wire::encode(sentence, bytes_)));
  }

  GnssSensor sensor_;
  std::array<std::uint8_t, 256> bytes_{};
};

}  // namespace

DevicePtr make_nmea0183_gnss(const DeviceSetup& setup) {
  return std::make_unique<Nmea0183Gnss>(setup);
}

}  // namespace drydock::emulate
