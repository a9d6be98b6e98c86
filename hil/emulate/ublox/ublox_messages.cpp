#include "hil/emulate/ublox/ublox_messages.hpp"

#include <cmath>
#include <numbers>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/ubx/ubx_put.hpp"
#include "estimators/frame/geodetic.hpp"

namespace drydock::emulate::ublox {
namespace {

constexpr double time_accuracy_s = 30e-9;

bool has_fix(const GnssEpoch& epoch) { return epoch.fix.position.has_value(); }

wire::UbxFixType type_of(const GnssEpoch& epoch) {
  return has_fix(epoch) ? wire::UbxFixType::three_d : wire::UbxFixType::none;
}

/// What the error of the speed across the way makes of the course.
double course_accuracy_rad(double speed_accuracy_mps, double ground_speed_mps) {
  if (speed_accuracy_mps >= std::numbers::pi * ground_speed_mps) return std::numbers::pi;
  return speed_accuracy_mps / ground_speed_mps;
}

wire::Ecef to_array(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

wire::UbxSatellite satellite_of(const measurement::Satellite& seen) {
  constexpr std::uint8_t code_and_carrier_locked = 7, broadcast_ephemeris = 1;
  wire::UbxSatellite satellite;
  satellite.gnss = static_cast<wire::UbxGnss>(seen.constellation);
  satellite.number = seen.number;
  satellite.cno_dbhz = seen.cno_dbhz;
  satellite.elevation_rad = seen.elevation_rad;
  satellite.azimuth_rad = seen.azimuth_rad;
  satellite.quality = code_and_carrier_locked;
  satellite.used = seen.used;
  satellite.healthy = true;
  satellite.orbit_source = broadcast_ephemeris;
  satellite.has_ephemeris = true;
  return satellite;
}

}  // namespace

wire::NavPvt nav_pvt(const GnssEpoch& epoch) {
  wire::NavPvt pvt;
  pvt.itow = epoch.time_of_week;
  if (epoch.time_is_known) {
    pvt.date = epoch.date;
    pvt.time_of_day = epoch.time_of_day;
  }
  pvt.time_resolved = epoch.time_is_known;
  const auto& fix = epoch.fix;
  pvt.satellites_used = static_cast<std::uint8_t>(fix.satellites_used.value_or(0));
  if (!fix.position) return pvt;
  pvt.time_accuracy_s = time_accuracy_s;
  pvt.fix_type = wire::UbxFixType::three_d;
  pvt.fix_ok = true;
  pvt.latitude_rad = fix.position->latitude_rad;
  pvt.longitude_rad = fix.position->longitude_rad;
  pvt.ellipsoidal_height_m = fix.ellipsoidal_height_m;
  pvt.mean_sea_level_height_m = fix.mean_sea_level_height_m;
  pvt.horizontal_accuracy_m = fix.horizontal_accuracy_m;
  pvt.vertical_accuracy_m = fix.vertical_accuracy_m;
  const Eigen::Vector3d& v = *fix.velocity_ned;
  pvt.velocity_north_mps = v.x();
  pvt.velocity_east_mps = v.y();
  pvt.velocity_down_mps = v.z();
  pvt.ground_speed_mps = std::hypot(v.x(), v.y());
  pvt.course_rad = course_rad(v);
  pvt.speed_accuracy_mps = fix.speed_accuracy_mps;
  pvt.course_accuracy_rad = course_accuracy_rad(*fix.speed_accuracy_mps, *pvt.ground_speed_mps);
  pvt.position_dop = fix.position_dop;
  return pvt;
}

wire::NavSat nav_sat(const GnssEpoch& epoch) {
  wire::NavSat message;
  message.itow = epoch.time_of_week;
  for (const auto& seen : epoch.sky.satellites) message.satellites.push_back(satellite_of(seen));
  return message;
}

wire::NavSvinfo nav_svinfo(const GnssEpoch& epoch) {
  wire::NavSvinfo message;
  message.itow = epoch.time_of_week;
  for (const auto& seen : epoch.sky.satellites)
    if (seen.constellation == measurement::Constellation::gps)
      message.satellites.push_back(satellite_of(seen));
  return message;
}

wire::NavSol nav_sol(const GnssEpoch& epoch) {
  wire::NavSol m;
  m.itow = epoch.time_of_week;
  if (epoch.time_is_known) m.gps_week = epoch.week;
  m.time_known = epoch.time_is_known;
  m.fix_type = type_of(epoch);
  m.fix_ok = has_fix(epoch);
  m.satellites_used = static_cast<std::uint8_t>(epoch.fix.satellites_used.value_or(0));
  if (!has_fix(epoch)) return m;
  const auto& fix = epoch.fix;
  const double latitude = fix.position->latitude_rad, longitude = fix.position->longitude_rad;
  m.position_ecef_m = to_array(frame::ecef({latitude, longitude, *fix.ellipsoidal_height_m}));
  m.velocity_ecef_mps =
      to_array(frame::ecef_to_ned(latitude, longitude).transpose() * *fix.velocity_ned);
  m.position_accuracy_m = std::hypot(*fix.horizontal_accuracy_m, *fix.vertical_accuracy_m);
  m.speed_accuracy_mps = fix.speed_accuracy_mps;
  m.position_dop = fix.position_dop;
  return m;
}

wire::NavStatus nav_status(const GnssEpoch& epoch, double uptime_s, double first_fix_s) {
  wire::NavStatus m;
  m.itow = epoch.time_of_week;
  m.fix_type = type_of(epoch);
  m.fix_ok = has_fix(epoch);
  m.week_known = m.time_known = epoch.time_is_known;
  m.time_to_first_fix_s = first_fix_s;
  m.uptime_s = uptime_s;
  return m;
}

wire::NavPosllh nav_posllh(const GnssEpoch& epoch) {
  wire::NavPosllh m;
  m.itow = epoch.time_of_week;
  if (!has_fix(epoch)) return m;
  const auto& fix = epoch.fix;
  m.latitude_rad = fix.position->latitude_rad;
  m.longitude_rad = fix.position->longitude_rad;
  m.ellipsoidal_height_m = fix.ellipsoidal_height_m;
  m.mean_sea_level_height_m = fix.mean_sea_level_height_m;
  m.horizontal_accuracy_m = fix.horizontal_accuracy_m;
  m.vertical_accuracy_m = fix.vertical_accuracy_m;
  return m;
}

wire::NavVelned nav_velned(const GnssEpoch& epoch) {
  wire::NavVelned m;
  m.itow = epoch.time_of_week;
  if (!has_fix(epoch)) return m;
  const Eigen::Vector3d& v = *epoch.fix.velocity_ned;
  m.velocity_north_mps = v.x();
  m.velocity_east_mps = v.y();
  m.velocity_down_mps = v.z();
  m.speed_mps = v.norm();
  m.ground_speed_mps = v.head<2>().norm();
  m.course_rad = course_rad(v);
  m.speed_accuracy_mps = epoch.fix.speed_accuracy_mps;
  m.course_accuracy_rad = course_accuracy_rad(*m.speed_accuracy_mps, *m.ground_speed_mps);
  return m;
}

wire::NavDop nav_dop(const GnssEpoch& epoch) {
  wire::NavDop m;
  m.itow = epoch.time_of_week;
  if (!epoch.dilution) return m;
  m.geometric = epoch.dilution->geometric;
  m.position = epoch.dilution->position;
  m.time = epoch.dilution->time;
  m.vertical = epoch.dilution->vertical;
  m.horizontal = epoch.dilution->horizontal;
  return m;
}

wire::NavTimeGps nav_timegps(const GnssEpoch& epoch) {
  wire::NavTimeGps m;
  m.itow = epoch.time_of_week;
  m.time_known = epoch.time_is_known;
  if (!epoch.time_is_known) return m;
  m.gps_week = epoch.week;
  m.leap_seconds = static_cast<int>(epoch.leap_seconds.count());
  m.time_accuracy_s = time_accuracy_s;
  return m;
}

std::size_t encode_utc(const GnssEpoch& epoch, std::span<std::uint8_t> out) {
  constexpr std::uint8_t valid_by_usno = 0x37;
  constexpr std::uint32_t unknown_accuracy = 0xFFFFFFFF;
  const auto payload = wire::ubx::payload_in(out, 20);
  if (payload.empty()) return 0;
  wire::store_le<std::uint32_t>(payload, 0, static_cast<std::uint32_t>(epoch.time_of_week.count()));
  wire::store_le<std::uint32_t>(payload, 4, unknown_accuracy);
  if (epoch.time_is_known) {
    const std::chrono::hh_mm_ss time(std::chrono::nanoseconds(epoch.time_of_day));
    const auto to_byte = [](auto value) { return static_cast<std::uint8_t>(value); };
    wire::store_le<std::uint32_t>(payload, 4, static_cast<std::uint32_t>(time_accuracy_s * 1e9));
    wire::store_le<std::int32_t>(payload, 8, static_cast<std::int32_t>(time.subseconds().count()));
    wire::store_le<std::uint16_t>(payload, 12,
                                  static_cast<std::uint16_t>(static_cast<int>(epoch.date.year())));
    payload[14] = to_byte(static_cast<unsigned>(epoch.date.month()));
    payload[15] = to_byte(static_cast<unsigned>(epoch.date.day()));
    payload[16] = to_byte(time.hours().count());
    payload[17] = to_byte(time.minutes().count());
    payload[18] = to_byte(time.seconds().count());
    payload[19] = valid_by_usno;
  }
  return wire::ubx::wrap(out, nav_timeutc, payload.size());
}

}  // namespace drydock::emulate::ublox
