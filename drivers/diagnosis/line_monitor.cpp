#include "drivers/diagnosis/line_monitor.hpp"

namespace drydock::diagnosis {

void LineMonitor::look(const device::Health& health, Stamp now) {
  using device::State;
  if (health.state == State::stale || health.state == State::waiting)
    see(Sign::silent, health.last_message_at.value_or(health.since), now,
        measurement::seconds(now - health.since), 0, "silence", "s");
  if (health.state == State::backing_off)
    see(Sign::port_lost, health.since, now, health.reopened, 0, "reopens", "");
  if (looked_) {
    const auto& was = last_.stream;
    if (health.stream.bad_checksums > was.bad_checksums)
      see(Sign::bad_checksums, now, now,
          static_cast<double>(health.stream.bad_checksums - was.bad_checksums), 0, "damaged frames",
          "");
    if (health.error_frames > last_.error_frames)
      see(Sign::error_frames, now, now,
          static_cast<double>(health.error_frames - last_.error_frames), 0, "error frames", "");
  }
  last_ = health;
  looked_ = true;
}

void LineMonitor::see(Sign sign, Stamp since, Stamp now, double value, double limit,
                      std::string_view quantity, std::string_view unit) {
  to_.see({.device = expected_.device,
           .sign = sign,
           .since = since,
           .at = now,
           .value = value,
           .limit = limit,
           .quantity = quantity,
           .unit = unit});
}

}  // namespace drydock::diagnosis
