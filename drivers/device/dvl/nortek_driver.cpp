#include "drivers/device/dvl/nortek_driver.hpp"

#include "drivers/device/dvl/velocity_accuracy.hpp"

namespace drydock::device {

namespace {

std::chrono::nanoseconds in_ns(double seconds) { return measurement::from_seconds(seconds); }

constexpr double oldest_echo_s = 2;

/// Time between the bottom echo and the sentence's first byte.
std::optional<std::chrono::nanoseconds> age_of(const wire::NortekTimes& times) {
  if (!times.after_sentence_s) return {};
  const double age_s = -*times.after_sentence_s;
  if (!(age_s >= 0 && age_s <= oldest_echo_s)) return {};
  return in_ns(age_s);
}

/// The sentence shows the time of its trigger; the echo came later. Empty: it does not say when.
std::optional<std::chrono::nanoseconds> echo_after_trigger(const wire::NortekTimes& times) {
  const double after_s = times.after_trigger_s.value_or(-1);
  if (!(after_s >= 0 && after_s <= oldest_echo_s)) return {};
  return in_ns(after_s);
}

/// Seconds of 32 bits, since 1970 or since the start: no clock of a DVL shows anything else.
bool is_clock_time(double s) { return s >= 0 && s < 4294967296.0; }

}  // namespace

void NortekDriver::on_frame(wire::Bytes frame, const Arrival& arrival, Output& out) {
  const auto message = wire::Nortek::decode(frame);
  const auto* velocity = message ? std::get_if<wire::NortekVelocity>(&*message) : nullptr;
  if (!velocity) return;
  const auto age = echo_.age(age_of(*velocity));
  publish(*velocity, age ? timing_.of_bytes(arrival, *age) : timing_.of_bytes(arrival), out);
}

void NortekDriver::publish(const wire::NortekVelocity& sentence, Origin origin, Output& out) {
  measurement::BottomVelocity result;
  if (const auto time_s = sentence.ping_time_s; time_s && is_clock_time(*time_s))
    origin.device_time = in_ns(*time_s) + echo_.after_trigger(echo_after_trigger(sentence));
  else if (time_s)
    out.refuse("a ping time that no clock has was left out");
  result.origin = origin;
  const auto& [x, y, z] = sentence.velocity_mps;
  if (x && y && z) result.velocity = mounting_.to_body({*x, *y, *z});
  result.range_m = sentence.distance_m;
  result.sound_speed_mps = sentence.sound_speed_mps;
  if (result.velocity) result.figure_of_merit_mps = merit_of(sentence.figure_of_merit_mps);
  finish_.publish(result, {sentence.temperature_k, {}}, out);
}

}  // namespace drydock::device
