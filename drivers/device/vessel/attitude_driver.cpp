#include "drivers/device/vessel/attitude_driver.hpp"

#include <numbers>

#include "drivers/device/vessel/attitude_gate.hpp"

namespace drydock::device {

namespace {
using measurement::AttitudeSample;
using measurement::HeadingReference;
constexpr std::chrono::seconds counts_for{3};  // compasses send at least once a second
constexpr double circle_rad = 2 * std::numbers::pi;

AttitudeSample sample_of(const Origin& origin, HeadingReference reference) {
  AttitudeSample sample;
  sample.origin = origin;
  sample.reference = reference;
  return sample;
}

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

/// False while a sentence before it in the ranks comes.
bool AttitudeDriver::counts(Rank rank, bool has_heading, Stamp at) {
  const auto own = static_cast<std::size_t>(rank);
  for (std::size_t i = 0; i < own; ++i)
    if (heard_at_[i] && at - *heard_at_[i] < counts_for) return false;
  if (has_heading) heard_at_[own] = at;
  return true;
}

void AttitudeDriver::on(const wire::Ths& ths, const Origin& origin, Output& out) {
  if (ths.mode.value == 'M' || ths.mode.value == 'S')
    return out.refuse("a heading typed in or simulated (THS mode M, S) was left out",
                      Refusal::no_measurement);
  counts(Rank::ths, ths.heading_rad.has_value(), origin.received_at);
  publish(ths.heading_rad, sample_of(origin, HeadingReference::true_north), out);
}

void AttitudeDriver::on(const wire::Hdt& hdt, const Origin& origin, Output& out) {
  if (!counts(Rank::hdt, hdt.heading_rad.has_value(), origin.received_at)) return;
  publish(hdt.heading_rad, sample_of(origin, HeadingReference::true_north), out);
}

void AttitudeDriver::on(const wire::Hdg& hdg, const Origin& origin, Output& out) {
  if (!counts(Rank::hdg, hdg.sensor_heading_rad.has_value(), origin.received_at)) return;
  AttitudeSample result = sample_of(origin, HeadingReference::magnetic_north);
  result.deviation_rad = hdg.deviation_rad;
  result.variation_rad = hdg.variation_rad;
  publish(hdg.sensor_heading_rad, result, out);
}

void AttitudeDriver::on(const wire::Hdm& hdm, const Origin& origin, Output& out) {
  if (!counts(Rank::hdm, hdm.heading_rad.has_value(), origin.received_at)) return;
  publish(hdm.heading_rad, sample_of(origin, HeadingReference::magnetic_north), out);
}

void AttitudeDriver::publish(const std::optional<double>& heading_rad,
                             measurement::AttitudeSample result, Output& out) {
  // This comparison is also false for numbers below 0.
  if (heading_rad && !(*heading_rad >= 0 && *heading_rad <= circle_rad))
    return out.refuse("a heading outside 0 to 360 degrees was dropped");
  if (!is_possible_heading({}, result.deviation_rad, result.variation_rad, out)) return;
  if (heading_rad) axes_.heading(*heading_rad, result);
  out.publish(result);
}

}  // namespace drydock::device
