#include "drivers/device/dvl/water_linked_driver.hpp"

#include "drivers/device/dvl/velocity_accuracy.hpp"
#include "drivers/device/reported.hpp"

namespace drydock::device {

namespace {

namespace water_linked = wire::water_linked;

/// A DVL that has power sends at least twice a second. A DVL that boots is silent for longer.
constexpr std::chrono::seconds silence_of_a_boot{2};
constexpr std::chrono::seconds new_form_counts_for{3};  // there are at least two reports a second
}  // namespace

void WaterLinkedDriver::on_frame(wire::Bytes frame, const Arrival& arrival, Output& out) {
  const auto message = wire::WaterLinked::decode(frame);
  if (!message) return;
  heed_silence(arrival.read_at, out);
  dialogue_.receive(*message, arrival.read_at, out);
  std::visit(
      [&](const auto& sentence) {
        if constexpr (requires { on(sentence, arrival, out); }) on(sentence, arrival, out);
      },
      *message);
}

void WaterLinkedDriver::restart(Stamp now, Output& out) {
  StreamDriver::restart(now, out);
  heard_at_.reset();
  // The recording contains the answers at their own times, so it plays as it was recorded.
  dialogue_.expect_no_answers(timing_.provenance() == measurement::Provenance::replayed);
  dialogue_.start(now, out);
}

void WaterLinkedDriver::on(const water_linked::BottomVelocity& report, const Arrival& arrival,
                           Output& out) {
  const auto age = age_.of(report, out);
  Origin origin = age ? timing_.of_bytes(arrival, *age) : timing_.of_bytes(arrival);
  origin.device_time = report.validity;
  new_form_at_ = origin.received_at;
  heed_heat(report.hot, out);
  auto sample = sample_of(report, report.altitude_m, origin);
  if (sample.velocity) {
    if (const auto covariance = covariance_of(report.covariance))
      sample.velocity_covariance = mounting_.covariance_to_body(*covariance);
  }
  finish_.publish(
      sample, {.temperature_k = {}, .depth_m = {}, .set_mps = dialogue_.sound_speed_mps()}, out);
}

void WaterLinkedDriver::on(const water_linked::OldVelocity& report, const Arrival& arrival,
                           Output& out) {
  const Origin origin = timing_.of_bytes(arrival);
  if (new_form_at_ && origin.received_at - *new_form_at_ < new_form_counts_for) return;
  heed_heat(report.hot.value_or(false), out);
  auto sample = sample_of(report, report.altitude_m, origin);
  finish_.publish(
      sample, {.temperature_k = {}, .depth_m = {}, .set_mps = dialogue_.sound_speed_mps()}, out);
}

measurement::BottomVelocity WaterLinkedDriver::sample_of(const water_linked::Report& report,
                                                         const std::optional<double>& altitude_m,
                                                         const Origin& origin) const {
  measurement::BottomVelocity result;
  result.origin = origin;
  const auto& [x, y, z] = report.velocity_mps;
  if (x && y && z && dialogue_.settings_hold()) result.velocity = mounting_.to_body({*x, *y, *z});
  if (result.velocity) result.figure_of_merit_mps = merit_of(report.figure_of_merit_mps);
  result.altitude_m = altitude_m;
  result.sound_speed_mps = dialogue_.sound_speed_mps();
  return result;
}

void WaterLinkedDriver::heed_silence(Stamp now, Output& out) {
  const bool was_silent = heard_at_ ? now - *heard_at_ > silence_of_a_boot : dialogue_.unanswered();
  heard_at_ = now;
  if (was_silent) dialogue_.start(now, out);
}

void WaterLinkedDriver::heed_heat(bool hot, Output& out) {
  if (hot && !hot_) out.report(hot_report);
  hot_ = hot;
}

}  // namespace drydock::device
