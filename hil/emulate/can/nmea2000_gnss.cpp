#include <algorithm>

#include "hil/emulate/can/nmea2000_device.hpp"
#include "hil/emulate/devices.hpp"
#include "hil/emulate/gnss/gnss_epoch.hpp"

namespace drydock::emulate {
namespace {

namespace n2k = wire::nmea2000;

constexpr std::array receiver_sends{n2k::CourseAndSpeed::pgn, n2k::GnssPosition::pgn,
                                    n2k::RapidPosition::pgn, n2k::Dilutions::pgn,
                                    n2k::SatellitesInView::pgn};
// NMEA 2000 class "navigation", function "ownship position, GNSS".
constexpr Nmea2000Product receiver{"GNSS receiver", 145, 60, 0x26, receiver_sends, {}};
constexpr std::uint8_t receiver_sequences = 253;  // SIDs above 252 are reserved

std::int64_t utc_ns(const GnssEpoch& epoch) {
  const auto day = std::chrono::sys_days{epoch.date}.time_since_epoch();
  return std::chrono::nanoseconds(day + epoch.time_of_day).count();
}

n2k::GnssPosition position_of(const GnssEpoch& epoch) {
  n2k::GnssPosition m;
  if (epoch.time_is_known) m.utc_ns = utc_ns(epoch);
  m.system = 0;  // GPS
  m.method = 0;
  if (epoch.fix.satellites_used)
    m.satellites = static_cast<std::uint8_t>(*epoch.fix.satellites_used);
  const auto& fix = epoch.fix;
  if (!fix.position) return m;
  m.method = 1;
  m.latitude_rad = fix.position->latitude_rad;
  m.longitude_rad = fix.position->longitude_rad;
  m.altitude_m = fix.ellipsoidal_height_m;
  m.geoid_height_m = *fix.ellipsoidal_height_m - *fix.mean_sea_level_height_m;
  m.horizontal_dop = epoch.dilution->horizontal;
  m.position_dop = epoch.dilution->position;
  return m;
}

n2k::RapidPosition rapid_position_of(const GnssEpoch& epoch) {
  n2k::RapidPosition m;
  if (!epoch.fix.position) return m;
  m.latitude_rad = epoch.fix.position->latitude_rad;
  m.longitude_rad = epoch.fix.position->longitude_rad;
  return m;
}

n2k::CourseAndSpeed course_of(const GnssEpoch& epoch) {
  n2k::CourseAndSpeed m;
  m.reference = n2k::true_north;
  if (!epoch.fix.velocity_ned) return m;
  m.course_rad = course_rad(*epoch.fix.velocity_ned);
  m.speed_mps = epoch.fix.velocity_ned->head<2>().norm();
  return m;
}

n2k::Dilutions dilutions_of(const GnssEpoch& epoch) {
  constexpr std::uint8_t automatic = 3, two_d = 1, three_d = 2;
  n2k::Dilutions m;
  m.desired_mode = automatic;
  m.actual_mode = epoch.fix.position ? three_d : two_d;
  if (!epoch.dilution) return m;
  m.horizontal_dop = epoch.dilution->horizontal;
  m.vertical_dop = epoch.dilution->vertical;
  return m;
}

/// The constellations with numbers of their own in PGN 129540.
std::optional<std::uint8_t> number_of(const measurement::Satellite& satellite) {
  switch (satellite.constellation) {
    case measurement::Constellation::gps: return satellite.number;
    case measurement::Constellation::sbas: return static_cast<std::uint8_t>(satellite.number - 87);
    case measurement::Constellation::glonass:
      return static_cast<std::uint8_t>(satellite.number + 64);
    default: return std::nullopt;
  }
}

n2k::SatellitesInView satellites_of(const GnssEpoch& epoch) {
  constexpr std::uint8_t tracked = 1, used = 2;
  n2k::SatellitesInView m;
  for (const auto& satellite : epoch.sky.satellites) {
    const auto number = number_of(satellite);
    if (!number || m.satellites.size() == m.satellites.capacity()) continue;
    n2k::SatelliteInView& seen = m.satellites.emplace_back();
    seen.number = number;
    seen.elevation_rad = satellite.elevation_rad;
    seen.azimuth_rad = satellite.azimuth_rad;
    seen.snr_db = satellite.cno_dbhz;
    seen.status = satellite.used ? used : tracked;
  }
  m.in_view = static_cast<std::uint8_t>(m.satellites.size());
  return m;
}

class Nmea2000Gnss final : public Nmea2000Device {
 public:
  explicit Nmea2000Gnss(const DeviceSetup& setup)
      : Nmea2000Device(setup, receiver), sensor_(setup) {
    sample_at_whole_multiples();
  }

 private:
  void measure(Stamp at, std::uint8_t address, Wire& out) override {
    const GnssEpoch epoch = sensor_.measure(trajectory().at(at), mounting());
    const auto from = [&](auto message) {
      message.source = address;
      if constexpr (requires { message.sequence; })
        message.sequence = static_cast<std::uint8_t>(samples() % receiver_sequences);
      return message;
    };
    out.send(encode(from(course_of(epoch))));
    send_packet(from(position_of(epoch)), packets_, out);
    out.send(encode(from(rapid_position_of(epoch))));
    out.send(encode(from(dilutions_of(epoch))));
    send_satellites(from(satellites_of(epoch)), out);
    ++packets_;
  }

  void send_satellites(const n2k::SatellitesInView& message, Wire& out) {
    std::array<std::uint8_t, n2k::SatellitesInView::longest> bytes;
    const std::size_t size = encode(message, bytes);
    send_packet(n2k::identifier_of(message), packets_, wire::Bytes{bytes}.first(size), out);
  }

  GnssSensor sensor_;
  std::uint8_t packets_ = 0;
};

}  // namespace

DevicePtr make_nmea2000_gnss(const DeviceSetup& setup) {
  return std::make_unique<Nmea2000Gnss>(setup);
}

}  // namespace drydock::emulate
