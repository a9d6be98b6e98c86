#include "drivers/wire/ubx_nav.hpp"

#include <array>
#include <cstdlib>

#include "drivers/wire/bytes.hpp"

namespace drydock::wire {
namespace {

constexpr std::uint32_t unknown_accuracy = 0xFFFFFFFF;

std::optional<double> accuracy(Bytes payload, std::size_t offset, double unit) {
  const auto raw = load_le<std::uint32_t>(payload, offset);
  return raw == unknown_accuracy ? std::nullopt : std::optional{raw * unit};
}

template <class T>
double value(Bytes payload, std::size_t offset, double unit) {
  return load_le<T>(payload, offset) * unit;
}

constexpr bool bit(unsigned word, unsigned number) { return (word >> number & 1u) != 0; }

void read_time(Bytes payload, NavPvt& m) {
  const unsigned valid = payload[11];
  const std::chrono::year_month_day date{std::chrono::year{load_le<std::uint16_t>(payload, 4)},
                                         std::chrono::month{payload[6]},
                                         std::chrono::day{payload[7]}};
  if (bit(valid, 0) && date.ok()) m.date = date;
  if (bit(valid, 1)) {
    m.time_of_day = std::chrono::hours{payload[8]} + std::chrono::minutes{payload[9]} +
                    std::chrono::seconds{payload[10]} +
                    std::chrono::nanoseconds{load_le<std::int32_t>(payload, 16)};
  }
  m.time_resolved = bit(valid, 2);
  m.time_accuracy_s = accuracy(payload, 12, 1e-9);
}

bool vouched_for(const NavPvt& m) {
  return m.fix_ok && m.fix_type >= UbxFixType::two_d && m.fix_type <= UbxFixType::gnss_and_dr;
}

void read_position(Bytes payload, NavPvt& m) {
  const auto longitude = load_le<std::int32_t>(payload, 24);
  const auto latitude = load_le<std::int32_t>(payload, 28);
  if (std::abs(std::int64_t{longitude}) > 1'800'000'000 ||
      std::abs(std::int64_t{latitude}) > 900'000'000) {
    return;
  }
  // Division by an exact 1e7 keeps the degrees correctly rounded.
  m.longitude_rad = radians(longitude / 1e7);
  m.latitude_rad = radians(latitude / 1e7);
  m.ellipsoidal_height_m = value<std::int32_t>(payload, 32, 1e-3);
  m.mean_sea_level_height_m = value<std::int32_t>(payload, 36, 1e-3);
}

void read_velocity(Bytes payload, NavPvt& m) {
  m.velocity_north_mps = value<std::int32_t>(payload, 48, 1e-3);
  m.velocity_east_mps = value<std::int32_t>(payload, 52, 1e-3);
  m.velocity_down_mps = value<std::int32_t>(payload, 56, 1e-3);
  m.ground_speed_mps = value<std::int32_t>(payload, 60, 1e-3);
  m.course_rad = radians(value<std::int32_t>(payload, 64, 1e-5));
}

void read_satellite(Bytes block, UbxSatellite& s) {
  const auto flags = load_le<std::uint32_t>(block, 8);
  const int elevation_deg = load_le<std::int8_t>(block, 3);
  const int azimuth_deg = load_le<std::int16_t>(block, 4);
  s.gnss = static_cast<UbxGnss>(block[0]);
  s.number = block[1];
  if (block[2] > 0) s.cno_dbhz = block[2];
  if (std::abs(elevation_deg) <= 90) {
    s.elevation_rad = radians(elevation_deg);
    if (azimuth_deg >= 0 && azimuth_deg <= 360) s.azimuth_rad = radians(azimuth_deg);
  }
  s.residual_m = value<std::int16_t>(block, 6, 0.1);
  s.quality = flags & 7;
  s.used = bit(flags, 3);
  const unsigned health = flags >> 4 & 3;
  if (health == 1 || health == 2) s.healthy = health == 1;
  s.orbit_source = flags >> 8 & 7;
  s.has_ephemeris = bit(flags, 11);
  s.has_almanac = bit(flags, 12);
}

std::chrono::milliseconds read_itow(Bytes payload) {
  return std::chrono::milliseconds{load_le<std::uint32_t>(payload, 0)};
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
  m.itow = read_itow(payload);
  read_time(payload, m);
  m.fix_type = static_cast<UbxFixType>(payload[20]);
  const unsigned flags = payload[21];
  m.fix_ok = bit(flags, 0);
  m.differential = bit(flags, 1);
  m.carrier_solution = static_cast<std::uint8_t>(flags >> 6);
  m.satellites_used = payload[23];
  const bool position_invalid = bit(payload[78], 0);
  if (vouched_for(m)) {
    if (!position_invalid) read_position(payload, m);
    read_velocity(payload, m);
  }
  m.horizontal_accuracy_m = accuracy(payload, 40, 1e-3);
  m.vertical_accuracy_m = accuracy(payload, 44, 1e-3);
  m.speed_accuracy_mps = accuracy(payload, 68, 1e-3);
  if (const auto sigma = accuracy(payload, 72, 1e-5)) m.course_accuracy_rad = radians(*sigma);
  m.position_dop = dilution(value<std::uint16_t>(payload, 76, 0.01));
  if (payload.size() == size) {
    if (bit(flags, 5)) m.vehicle_heading_rad = radians(value<std::int32_t>(payload, 84, 1e-5));
    if (bit(payload[11], 3)) {
      m.magnetic_declination_rad = radians(value<std::int16_t>(payload, 88, 0.01));
      m.magnetic_accuracy_rad = radians(value<std::uint16_t>(payload, 90, 0.01));
    }
  }
  return true;
}

bool read(Bytes payload, NavSat& m) {
  constexpr std::size_t head = 8, block = 12;
  if (payload.size() < head || payload.size() != head + block * payload[5]) return false;
  m.itow = read_itow(payload);
  m.satellites.clear();
  for (std::size_t at = head; at < payload.size(); at += block) {
    read_satellite(payload.subspan(at, block), m.satellites.emplace_back());
  }
  return true;
}

bool read(Bytes payload, NavEoe& m) {
  if (payload.size() != 4) return false;
  m.itow = read_itow(payload);
  return true;
}

}  // namespace drydock::wire
