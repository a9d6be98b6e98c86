#include "drivers/device/vessel/emlog_driver.hpp"

namespace drydock::device {

namespace {
constexpr std::chrono::seconds vbw_counts_for{3};  // logs send at least once a second
}

void EmLogDriver::on_frame(wire::Bytes frame, const Arrival& arrival, Output& out) {
  const auto message = wire::Nmea0183::decode(frame);
  if (!message) return;
  const Origin origin =
      burst_.of(timing_.of_bytes(arrival), timing_.line_time(frame.size()), message->index());
  std::visit(
      [&](const auto& sentence) {
        if constexpr (requires { on(sentence, origin, out); }) on(sentence, origin, out);
      },
      *message);
}

void EmLogDriver::on(const wire::Vhw& vhw, const Origin& origin, Output& out) {
  if (vbw_at_ && origin.received_at - *vbw_at_ < vbw_counts_for) return;
  axes_.publish(vhw.speed_mps, {}, origin, out);
}

void EmLogDriver::on(const wire::Vbw& vbw, const Origin& origin, Output& out) {
  if (vbw.water_longitudinal_mps) vbw_at_ = origin.received_at;
  axes_.publish(vbw.water_longitudinal_mps, vbw.water_transverse_mps, origin, out);
}

void EmLogDriver::on(const wire::Vlw& vlw, const Origin& origin, Output& out) {
  if (!vlw.water_total_m) return;
  measurement::WaterSpeed result;
  result.origin = origin;
  result.distance_m = axes_.way(vlw.water_total_m);
  out.publish(result);
}

}  // namespace drydock::device
