#include "drivers/wire/ubx/ubx_nav.hpp"
#include "drivers/wire/ubx/ubx_put.hpp"

namespace drydock::wire {
namespace {

using namespace ubx;

/// The six fields are those of the time rounded to a hundredth of a second, and the rest is signed:
/// nano lies from -5 000 000 to 994 999 999 (UBX-18010854, "UTC representation").
void put_time(PayloadOut payload, const NavPvt& m) {
  using namespace std::chrono;
  auto date = m.date;
  const nanoseconds time = m.time_of_day.value_or(nanoseconds{0});
  using Hundredths = std::chrono::duration<std::int64_t, std::centi>;
  auto whole = floor<std::chrono::seconds>(std::chrono::round<Hundredths>(time));
  const nanoseconds rest = time - whole;
  if (whole >= days{1} && date) {
    date = year_month_day{sys_days{*date} + days{1}};
    whole -= days{1};
  }
  if (date) {
    store_le<std::uint16_t>(payload, 4, static_cast<std::uint16_t>(static_cast<int>(date->year())));
    payload[6] = static_cast<std::uint8_t>(static_cast<unsigned>(date->month()));
    payload[7] = static_cast<std::uint8_t>(static_cast<unsigned>(date->day()));
  }
  payload[8] = static_cast<std::uint8_t>(whole / hours{1});
  payload[9] = static_cast<std::uint8_t>(whole % hours{1} / minutes{1});
  payload[10] = static_cast<std::uint8_t>(whole.count() % 60);
  store_le<std::int32_t>(payload, 16, static_cast<std::int32_t>(rest.count()));
  payload[11] = static_cast<std::uint8_t>(
      flag(m.date.has_value(), 0) | flag(m.time_of_day.has_value(), 1) | flag(m.time_resolved, 2) |
      flag(m.magnetic_declination_rad.has_value(), 3));
  put_accuracy(payload, 12, m.time_accuracy_s, 1e-9);
}

void put_position(PayloadOut payload, const NavPvt& m) {
  put<std::int32_t>(payload, 24, degrees(m.longitude_rad), 1e-7);
  put<std::int32_t>(payload, 28, degrees(m.latitude_rad), 1e-7);
  put<std::int32_t>(payload, 32, m.ellipsoidal_height_m, 1e-3);
  put<std::int32_t>(payload, 36, m.mean_sea_level_height_m, 1e-3);
  put_accuracy(payload, 40, m.horizontal_accuracy_m, 1e-3);
  put_accuracy(payload, 44, m.vertical_accuracy_m, 1e-3);
  payload[78] = static_cast<std::uint8_t>(flag(!m.latitude_rad || !m.longitude_rad, 0));
}

void put_velocity(PayloadOut payload, const NavPvt& m) {
  put<std::int32_t>(payload, 48, m.velocity_north_mps, 1e-3);
  put<std::int32_t>(payload, 52, m.velocity_east_mps, 1e-3);
  put<std::int32_t>(payload, 56, m.velocity_down_mps, 1e-3);
  put<std::int32_t>(payload, 60, m.ground_speed_mps, 1e-3);
  put<std::int32_t>(payload, 64, degrees(m.course_rad), 1e-5);
  put_accuracy(payload, 68, m.speed_accuracy_mps, 1e-3);
  put_accuracy(payload, 72, degrees(m.course_accuracy_rad), 1e-5);
}

void put_satellite(PayloadOut block, const UbxSatellite& s) {
  constexpr std::int8_t unknown_elevation = -91;
  constexpr unsigned health_unknown = 0, health_ok = 1, health_bad = 2;
  block[0] = static_cast<std::uint8_t>(s.gnss);
  block[1] = s.number;
  put<std::uint8_t>(block, 2, s.cno_dbhz, 1);
  put<std::int8_t>(block, 3, degrees(s.elevation_rad), 1, unknown_elevation);
  put<std::int16_t>(block, 4, degrees(s.azimuth_rad), 1);
  put<std::int16_t>(block, 6, s.residual_m, 0.1);
  const unsigned health = !s.healthy ? health_unknown : *s.healthy ? health_ok : health_bad;
  store_le<std::uint32_t>(block, 8,
                          (s.quality & 7u) | flag(s.used, 3) | health << 4 |
                              (s.orbit_source & 7u) << 8 | flag(s.has_ephemeris, 11) |
                              flag(s.has_almanac, 12));
}

}  // namespace

std::size_t encode(const NavPvt& m, std::span<std::uint8_t> out) {
  const PayloadOut payload = payload_in(out, 92);
  if (payload.empty()) return 0;
  const bool has_velocity = m.velocity_north_mps && m.velocity_east_mps && m.velocity_down_mps;
  store_le<std::uint32_t>(payload, 0, static_cast<std::uint32_t>(m.itow.count()));
  put_time(payload, m);
  payload[20] = static_cast<std::uint8_t>(m.fix_type);
  payload[21] = static_cast<std::uint8_t>(
      flag(m.fix_ok && has_velocity, 0) | flag(m.differential, 1) |
      flag(m.vehicle_heading_rad.has_value(), 5) | (m.carrier_solution & 3u) << 6);
  payload[23] = m.satellites_used;
  put_position(payload, m);
  put_velocity(payload, m);
  put_dop(payload, 76, m.position_dop);
  put<std::int32_t>(payload, 84, degrees(m.vehicle_heading_rad), 1e-5);
  put<std::int16_t>(payload, 88, degrees(m.magnetic_declination_rad), 0.01);
  put<std::uint16_t>(payload, 90, degrees(m.magnetic_accuracy_rad), 0.01);
  return ubx::wrap(out, NavPvt::class_and_id, payload.size());
}

std::size_t encode(const NavSat& m, std::span<std::uint8_t> out) {
  const PayloadOut payload = payload_in(out, 8 + 12 * m.satellites.size());
  if (payload.empty()) return 0;
  store_le<std::uint32_t>(payload, 0, static_cast<std::uint32_t>(m.itow.count()));
  payload[4] = 1;  // version
  payload[5] = static_cast<std::uint8_t>(m.satellites.size());
  for (std::size_t i = 0; i < m.satellites.size(); ++i) {
    put_satellite(payload.subspan(8 + 12 * i, 12), m.satellites[i]);
  }
  return ubx::wrap(out, NavSat::class_and_id, payload.size());
}

std::size_t encode(const NavEoe& m, std::span<std::uint8_t> out) {
  const PayloadOut payload = payload_in(out, 4);
  if (payload.empty()) return 0;
  store_le<std::uint32_t>(payload, 0, static_cast<std::uint32_t>(m.itow.count()));
  return ubx::wrap(out, NavEoe::class_and_id, payload.size());
}

}  // namespace drydock::wire
