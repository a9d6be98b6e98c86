#include "drivers/wire/ubx/ubx_time.hpp"

#include "drivers/wire/ubx/ubx_payload.hpp"

namespace drydock::wire {

bool read(Bytes payload, NavTimeGps& m) {
  if (payload.size() != 16) return false;
  const unsigned valid = payload[11];
  m.itow = ubx::itow(payload);
  m.itow_fraction = std::chrono::nanoseconds{load_le<std::int32_t>(payload, 4)};
  m.time_known = ubx::bit(valid, 0);
  if (ubx::bit(valid, 1)) m.gps_week = load_le<std::int16_t>(payload, 8);
  if (ubx::bit(valid, 2)) m.leap_seconds = load_le<std::int8_t>(payload, 10);
  m.time_accuracy_s = ubx::accuracy(payload, 12, 1e9);
  return true;
}

bool read(Bytes payload, NavTimeUtc& m) {
  if (payload.size() != 20) return false;
  constexpr unsigned all_known = 0b111;  // bits for time of week, week, leap seconds
  m.itow = ubx::itow(payload);
  m.time_accuracy_s = ubx::accuracy(payload, 4, 1e9);
  if ((payload[19] & all_known) != all_known) return true;
  m.date = ubx::date(payload, 12);
  if (m.date) m.time_of_day = ubx::time_of_day(payload, 16, 8);
  return true;
}

}  // namespace drydock::wire
