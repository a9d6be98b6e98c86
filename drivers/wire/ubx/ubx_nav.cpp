#include "drivers/wire/ubx/ubx_nav.hpp"

#include <array>

#include "drivers/wire/ubx/ubx_payload.hpp"

namespace drydock::wire {
namespace {

using ubx::accuracy;
using ubx::bit;
using ubx::value;

void read_time(Bytes payload, NavPvt& m) {
  const unsigned valid = payload[11];
  if (bit(valid, 0)) m.date = ubx::date(payload, 4);
  if (bit(valid, 1)) m.time_of_day = ubx::time_of_day(payload, 8, 16);
  m.time_resolved = bit(valid, 2);
  m.time_accuracy_s = accuracy(payload, 12, 1e9);
}

void read_position(Bytes payload, NavPvt& m) {
  if (!ubx::read_position(payload, 24, m.latitude_rad, m.longitude_rad)) return;
  m.ellipsoidal_height_m = value<std::int32_t>(payload, 32, 1e3);
  m.mean_sea_level_height_m = value<std::int32_t>(payload, 36, 1e3);
}

void read_velocity(Bytes payload, NavPvt& m) {
  m.velocity_north_mps = value<std::int32_t>(payload, 48, 1e3);
  m.velocity_east_mps = value<std::int32_t>(payload, 52, 1e3);
  m.velocity_down_mps = value<std::int32_t>(payload, 56, 1e3);
  m.ground_speed_mps = value<std::int32_t>(payload, 60, 1e3);
  m.course_rad = radians(value<std::int32_t>(payload, 64, 1e5));
}

void read_satellite(Bytes block, UbxSatellite& s) {
  const auto flags = load_le<std::uint32_t>(block, 8);
  s.gnss = static_cast<UbxGnss>(block[0]);
  s.number = block[1];
  s.cno_dbhz = ubx::carrier_to_noise(block, 2);
  ubx::read_direction(block, 3, s.elevation_rad, s.azimuth_rad);
  s.residual_m = value<std::int16_t>(block, 6, 10);
  s.quality = flags & 7;
  s.used = bit(flags, 3);
  s.healthy = ubx::health(flags >> 4 & 3);
  s.orbit_source = flags >> 8 & 7;
  s.has_ephemeris = bit(flags, 11);
  s.has_almanac = bit(flags, 12);
}

}  // namespace

std::string_view to_string(UbxGnss gnss) {
  constexpr std::array<std::string_view, 8> names{"gps",  "sbas", "galileo", "beidou",
                                                  "imes", "qzss", "glonass", "navic"};
  const auto index = static_cast<std::size_t>(gnss);
  return index < names.size() ? names[index] : "unknown";
}

bool read(Bytes payload, NavPvt& m) {
  constexpr std::size_t old_size = 84, size = 92;
  if (payload.size() != size && payload.size() != old_size) return false;
  m.itow = ubx::itow(payload);
  read_time(payload, m);
  m.fix_type = static_cast<UbxFixType>(payload[20]);
  const unsigned flags = payload[21];
  m.fix_ok = bit(flags, 0);
  m.differential = bit(flags, 1);
  m.carrier_solution = static_cast<std::uint8_t>(flags >> 6);
  m.satellites_used = payload[23];
  const bool position_invalid = bit(payload[78], 0);
  if (vouched_for(m.fix_type, m.fix_ok)) {
    if (!position_invalid) read_position(payload, m);
    read_velocity(payload, m);
  }
  m.horizontal_accuracy_m = accuracy(payload, 40, 1e3);
  m.vertical_accuracy_m = accuracy(payload, 44, 1e3);
  m.speed_accuracy_mps = accuracy(payload, 68, 1e3);
  if (const auto sigma = accuracy(payload, 72, 1e5)) m.course_accuracy_rad = radians(*sigma);
  m.position_dop = ubx::dop(payload, 76);
  if (payload.size() == size) {
    if (bit(flags, 5)) m.vehicle_heading_rad = radians(value<std::int32_t>(payload, 84, 1e5));
    if (bit(payload[11], 3)) {
      m.magnetic_declination_rad = radians(value<std::int16_t>(payload, 88, 1e2));
      m.magnetic_accuracy_rad = radians(value<std::uint16_t>(payload, 90, 1e2));
    }
  }
  return true;
}

bool read(Bytes payload, NavSat& m) {
  constexpr std::size_t head = 8, block = 12;
  if (payload.size() < head || payload.size() != head + block * payload[5]) return false;
  m.itow = ubx::itow(payload);
  m.satellites.clear();
  for (std::size_t at = head; at < payload.size(); at += block) {
    read_satellite(payload.subspan(at, block), m.satellites.emplace_back());
  }
  return true;
}

bool read(Bytes payload, NavEoe& m) {
  if (payload.size() != 4) return false;
  m.itow = ubx::itow(payload);
  return true;
}

}  // namespace drydock::wire
