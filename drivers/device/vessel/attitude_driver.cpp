#include "drivers/device/vessel/attitude_driver.hpp"

#include <numbers>

namespace drydock::device {

namespace {
constexpr std::chrono::seconds ths_counts_for{3};  // compasses send at least once a second
constexpr double circle_rad = 2 * std::numbers::pi;
}  // namespace

void AttitudeDriver::on_frame(wire::Bytes frame, const Arrival& arrival, Output& out) {
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

void AttitudeDriver::on(const wire::Hdt& hdt, const Origin& origin, Output& out) {
  if (ths_at_ && origin.received_at - *ths_at_ < ths_counts_for) return;
  publish(hdt.heading_rad, origin, out);
}

void AttitudeDriver::on(const wire::Ths& ths, const Origin& origin, Output& out) {
  if (ths.mode.value == 'M' || ths.mode.value == 'S')
    return out.refuse("a heading typed in or simulated (THS mode M, S) was left out",
                      Refusal::no_measurement);
  if (ths.heading_rad) ths_at_ = origin.received_at;
  publish(ths.heading_rad, origin, out);
}

void AttitudeDriver::publish(const std::optional<double>& true_heading_rad, const Origin& origin,
                             Output& out) {
  // This comparison is also false for numbers below 0.
  if (true_heading_rad && !(*true_heading_rad >= 0 && *true_heading_rad <= circle_rad))
    return out.refuse("a heading outside 0 to 360 degrees was dropped");
  measurement::AttitudeSample result;
  result.origin = origin;
  result.reference = measurement::HeadingReference::true_north;
  if (true_heading_rad) axes_.heading(*true_heading_rad, result);
  out.publish(result);
}

}  // namespace drydock::device
