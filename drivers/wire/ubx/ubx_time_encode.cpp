#include "drivers/wire/ubx/ubx_put.hpp"
#include "drivers/wire/ubx/ubx_time.hpp"

namespace drydock::wire {

std::size_t encode(const NavTimeGps& m, std::span<std::uint8_t> out) {
  const auto payload = ubx::payload_in(out, 16);
  if (payload.empty()) return 0;
  store_le<std::uint32_t>(payload, 0, static_cast<std::uint32_t>(m.itow.count()));
  store_le<std::int32_t>(payload, 4, static_cast<std::int32_t>(m.itow_fraction.count()));
  store_le<std::int16_t>(payload, 8, static_cast<std::int16_t>(m.gps_week.value_or(0)));
  payload[10] = static_cast<std::uint8_t>(m.leap_seconds.value_or(0));
  payload[11] =
      static_cast<std::uint8_t>(ubx::flag(m.time_known, 0) | ubx::flag(m.gps_week.has_value(), 1) |
                                ubx::flag(m.leap_seconds.has_value(), 2));
  ubx::put_accuracy(payload, 12, m.time_accuracy_s, 1e-9);
  return ubx::wrap(out, NavTimeGps::class_and_id, payload.size());
}

}  // namespace drydock::wire
