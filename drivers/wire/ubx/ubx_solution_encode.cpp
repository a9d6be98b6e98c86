#include "drivers/wire/ubx/ubx_put.hpp"
#include "drivers/wire/ubx/ubx_solution.hpp"

namespace drydock::wire {
namespace {

void put_ecef(ubx::PayloadOut payload, std::size_t offset, const Ecef& ecef) {
  for (std::size_t i = 0; i < ecef.size(); ++i)
    ubx::put<std::int32_t>(payload, offset + 4 * i, ecef[i], 0.01);
}

template <class Message>
ubx::PayloadOut begin(const Message& m, std::span<std::uint8_t> out, std::size_t size) {
  const auto payload = ubx::payload_in(out, size);
  if (!payload.empty())
    store_le<std::uint32_t>(payload, 0, static_cast<std::uint32_t>(m.itow.count()));
  return payload;
}

std::uint8_t fix_flags(bool fix_ok, bool differential, bool week_known, bool time_known) {
  return static_cast<std::uint8_t>(ubx::flag(fix_ok, 0) | ubx::flag(differential, 1) |
                                   ubx::flag(week_known, 2) | ubx::flag(time_known, 3));
}

}  // namespace

std::size_t encode(const NavSol& m, std::span<std::uint8_t> out) {
  const auto payload = begin(m, out, 52);
  if (payload.empty()) return 0;
  store_le<std::int32_t>(payload, 4, static_cast<std::int32_t>(m.itow_fraction.count()));
  store_le<std::int16_t>(payload, 8, static_cast<std::int16_t>(m.gps_week.value_or(0)));
  payload[10] = static_cast<std::uint8_t>(m.fix_type);
  payload[11] = fix_flags(m.fix_ok, m.differential, m.gps_week.has_value(), m.time_known);
  put_ecef(payload, 12, m.position_ecef_m);
  ubx::put_accuracy(payload, 24, m.position_accuracy_m, 0.01);
  put_ecef(payload, 28, m.velocity_ecef_mps);
  ubx::put_accuracy(payload, 40, m.speed_accuracy_mps, 0.01);
  ubx::put_dop(payload, 44, m.position_dop);
  payload[47] = m.satellites_used;
  return ubx::wrap(out, NavSol::class_and_id, payload.size());
}

std::size_t encode(const NavStatus& m, std::span<std::uint8_t> out) {
  const auto payload = begin(m, out, 16);
  if (payload.empty()) return 0;
  payload[4] = static_cast<std::uint8_t>(m.fix_type);
  payload[5] = fix_flags(m.fix_ok, m.differential, m.week_known, m.time_known);
  ubx::put<std::uint32_t>(payload, 8, m.time_to_first_fix_s, 1e-3);
  ubx::put<std::uint32_t>(payload, 12, m.uptime_s, 1e-3);
  return ubx::wrap(out, NavStatus::class_and_id, payload.size());
}

std::size_t encode(const NavPosllh& m, std::span<std::uint8_t> out) {
  const auto payload = begin(m, out, 28);
  if (payload.empty()) return 0;
  ubx::put<std::int32_t>(payload, 4, degrees(m.longitude_rad), 1e-7);
  ubx::put<std::int32_t>(payload, 8, degrees(m.latitude_rad), 1e-7);
  ubx::put<std::int32_t>(payload, 12, m.ellipsoidal_height_m, 1e-3);
  ubx::put<std::int32_t>(payload, 16, m.mean_sea_level_height_m, 1e-3);
  ubx::put_accuracy(payload, 20, m.horizontal_accuracy_m, 1e-3);
  ubx::put_accuracy(payload, 24, m.vertical_accuracy_m, 1e-3);
  return ubx::wrap(out, NavPosllh::class_and_id, payload.size());
}

std::size_t encode(const NavVelned& m, std::span<std::uint8_t> out) {
  const auto payload = begin(m, out, 36);
  if (payload.empty()) return 0;
  ubx::put<std::int32_t>(payload, 4, m.velocity_north_mps, 0.01);
  ubx::put<std::int32_t>(payload, 8, m.velocity_east_mps, 0.01);
  ubx::put<std::int32_t>(payload, 12, m.velocity_down_mps, 0.01);
  ubx::put<std::uint32_t>(payload, 16, m.speed_mps, 0.01);
  ubx::put<std::uint32_t>(payload, 20, m.ground_speed_mps, 0.01);
  ubx::put<std::int32_t>(payload, 24, degrees(m.course_rad), 1e-5);
  ubx::put_accuracy(payload, 28, m.speed_accuracy_mps, 0.01);
  ubx::put_accuracy(payload, 32, degrees(m.course_accuracy_rad), 1e-5);
  return ubx::wrap(out, NavVelned::class_and_id, payload.size());
}

std::size_t encode(const NavDop& m, std::span<std::uint8_t> out) {
  const auto payload = begin(m, out, 18);
  if (payload.empty()) return 0;
  std::size_t at = 4;
  for (const auto& dop :
       {m.geometric, m.position, m.time, m.vertical, m.horizontal, m.north, m.east}) {
    ubx::put_dop(payload, at, dop);
    at += 2;
  }
  return ubx::wrap(out, NavDop::class_and_id, payload.size());
}

}  // namespace drydock::wire
