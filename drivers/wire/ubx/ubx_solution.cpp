#include "drivers/wire/ubx/ubx_solution.hpp"

#include "drivers/wire/ubx/ubx_payload.hpp"

namespace drydock::wire {
namespace {

using ubx::accuracy;
using ubx::bit;
using ubx::value;

/// Reads three integers in steps of 1e-2.
Ecef read_ecef(Bytes payload, std::size_t offset) {
  Ecef ecef;
  for (std::size_t i = 0; i < ecef.size(); ++i) {
    ecef[i] = value<std::int32_t>(payload, offset + 4 * i, 1e2);
  }
  return ecef;
}

}  // namespace

bool read(Bytes payload, NavSol& m) {
  if (payload.size() != 52) return false;
  const unsigned flags = payload[11];
  m.itow = ubx::itow(payload);
  m.itow_fraction = std::chrono::nanoseconds{load_le<std::int32_t>(payload, 4)};
  if (bit(flags, 2)) m.gps_week = load_le<std::int16_t>(payload, 8);
  m.time_known = bit(flags, 3);
  m.fix_type = static_cast<UbxFixType>(payload[10]);
  m.fix_ok = bit(flags, 0);
  m.differential = bit(flags, 1);
  if (vouched_for(m.fix_type, m.fix_ok)) {
    m.position_ecef_m = read_ecef(payload, 12);
    m.velocity_ecef_mps = read_ecef(payload, 28);
  }
  m.position_accuracy_m = accuracy(payload, 24, 1e2);
  m.speed_accuracy_mps = accuracy(payload, 40, 1e2);
  m.position_dop = ubx::dop(payload, 44);
  m.satellites_used = payload[47];
  return true;
}

bool read(Bytes payload, NavStatus& m) {
  if (payload.size() != 16) return false;
  const unsigned flags = payload[5];
  m.itow = ubx::itow(payload);
  m.fix_type = static_cast<UbxFixType>(payload[4]);
  m.fix_ok = bit(flags, 0);
  m.differential = bit(flags, 1);
  m.week_known = bit(flags, 2);
  m.time_known = bit(flags, 3);
  m.time_to_first_fix_s = value<std::uint32_t>(payload, 8, 1e3);
  m.uptime_s = value<std::uint32_t>(payload, 12, 1e3);
  return true;
}

bool read(Bytes payload, NavPosllh& m) {
  if (payload.size() != 28) return false;
  m.itow = ubx::itow(payload);
  m.horizontal_accuracy_m = accuracy(payload, 20, 1e3);
  m.vertical_accuracy_m = accuracy(payload, 24, 1e3);
  if (!m.horizontal_accuracy_m) return true;
  if (!ubx::read_position(payload, 4, m.latitude_rad, m.longitude_rad)) return true;
  if (!m.vertical_accuracy_m) return true;
  m.ellipsoidal_height_m = value<std::int32_t>(payload, 12, 1e3);
  m.mean_sea_level_height_m = value<std::int32_t>(payload, 16, 1e3);
  return true;
}

bool read(Bytes payload, NavVelned& m) {
  if (payload.size() != 36) return false;
  m.itow = ubx::itow(payload);
  m.speed_accuracy_mps = accuracy(payload, 28, 1e2);
  if (const auto sigma = accuracy(payload, 32, 1e5)) m.course_accuracy_rad = radians(*sigma);
  if (!m.speed_accuracy_mps) return true;
  m.velocity_north_mps = value<std::int32_t>(payload, 4, 1e2);
  m.velocity_east_mps = value<std::int32_t>(payload, 8, 1e2);
  m.velocity_down_mps = value<std::int32_t>(payload, 12, 1e2);
  m.speed_mps = value<std::uint32_t>(payload, 16, 1e2);
  m.ground_speed_mps = value<std::uint32_t>(payload, 20, 1e2);
  m.course_rad = radians(value<std::int32_t>(payload, 24, 1e5));
  return true;
}

bool read(Bytes payload, NavDop& m) {
  if (payload.size() != 18) return false;
  m.itow = ubx::itow(payload);
  m.geometric = ubx::dop(payload, 4);
  m.position = ubx::dop(payload, 6);
  m.time = ubx::dop(payload, 8);
  m.vertical = ubx::dop(payload, 10);
  m.horizontal = ubx::dop(payload, 12);
  m.north = ubx::dop(payload, 14);
  m.east = ubx::dop(payload, 16);
  return true;
}

}  // namespace drydock::wire
